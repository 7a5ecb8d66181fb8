#include <cmath>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "proofs_checks/instances/solved_instances.hpp"
#include "proofs_checks/kit/numbers.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {
namespace {

enum class Change { rising, falling, none };

/// Returns a problem with contact around x = 0, where the slope jumps upwards and the friction changes.
ContactProblem problem_with(Change change, Random& random) {
  const Rational low = random.between(Rational(1, 10), 1);
  const Rational high = low + random.between(Rational(1, 2), 3);
  const Rational behind = change == Change::falling ? high : low;
  const Rational in_front = change == Change::rising ? high : low;
  const Rational curve = random.between(Rational(1, 2), 2);
  const Polynomial left({0, -random.between(Rational(1, 20), Rational(1, 2)), curve});
  const Polynomial right({0, random.between(Rational(1, 20), Rational(1, 2)), curve});
  return {Elasticity::reduced(Rational(1, 2)), FrictionProfile({2 * behind, 2 * in_front}, {0}),
          Indenter(-1, {{0, left}, {1, right}}), random.between(Rational(1, 2), 2)};
}

/// Fits the local form to the values in front of the point. The coefficients come from the traction, not from the
/// intensities that the solver reports.
Instance fitted(const ContactProblem& problem, const numeric::ContactSolution<double>& solution) {
  constexpr double d = 1e-6;
  const auto behind = to_real<double>(problem.coupled_friction(0));
  const auto in_front = to_real<double>(problem.coupled_friction(1));
  const double pi = std::acos(-1.0);
  const double p = (std::atan(behind) - std::atan(in_front)) / pi;
  const double w_l = 1 / std::hypot(1, behind);
  const double w_r = 1 / std::hypot(1, in_front);
  const auto traction = [&](double distance) { return solution.at(Rational(distance)).traction.left.value; };
  const double near = traction(2 * d);
  const double far = traction(4 * d);
  double limit = 0, wedge = 0, theta = 0;
  if (p == 0) {
    const double square = 1 + in_front * in_front;
    wedge = (far - near) * pi * square / std::log(2.0);
    theta = -(near - wedge * (std::log(2 * d) / pi + in_front) / square) / w_r;
  } else {
    theta = -(far - near) / (w_r * (std::pow(4 * d, p) - std::pow(2 * d, p)));
    limit = near + w_r * theta * std::pow(2 * d, p);
  }
  return {{{"d", d},
           {"s", in_front},
           {"p", p},
           {"D", wedge},
           {"limit", limit},
           {"pole", 0},
           {"theta", theta},
           {"w_l", w_l},
           {"w_r", w_r},
           {"t_l", traction(-d)},
           {"t_r", traction(d)},
           {"accuracy", Real50("1e-4")}}};
}

std::vector<Instance> solved(Change change) {
  std::vector<Instance> all;
  Random random(2016, "solved-points-" + std::to_string(static_cast<int>(change)));
  for (int attempt = 0; attempt < 20 && all.size() < 6; ++attempt) {
    const ContactProblem problem = problem_with(change, random);
    const auto solution = numeric::riemann_hilbert<double>(problem).solution;
    if (solution && solution->failed_condition().empty()) all.push_back(fitted(problem, *solution));
  }
  return all;
}

}  // namespace

std::vector<Instance> solved_rising_jumps() { return solved(Change::rising); }
std::vector<Instance> solved_falling_jumps() { return solved(Change::falling); }
std::vector<Instance> solved_wedges() { return solved(Change::none); }

}  // namespace steadyslide::proofs_checks
