#include "proofs_checks/instruments/operators/moment_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "numeric/riemann_hilbert/traction_density.hpp"
#include "numeric/variational/lemke.hpp"
#include "numeric/variational/nested_solve.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"

namespace steadyslide::proofs_checks {
namespace {

double chebyshev(std::size_t k, double x) { return std::cos(static_cast<double>(k) * std::acos(x)); }

/// Returns the antiderivative of T_k at x.
double chebyshev_integral(std::size_t k, double x) {
  const auto n = static_cast<double>(k);
  if (k == 0) return x;
  if (k == 1) return x * x / 2;
  return chebyshev(k + 1, x) / (2 * (n + 1)) - chebyshev(k - 1, x) / (2 * (n - 1));
}

}  // namespace

ContactProblem DualCase::problem(int friction_sign) const {
  return cell_problem({{friction_sign * s}, {}}, profile, load);
}

std::function<double(double)> DualCase::height() const {
  return [p = coefficients_of<double>(profile)](double x) { return value_of(p, x); };
}

std::vector<DualCase> dual_cases(const Context& context) {
  std::vector<DualCase> all{
      {"parabola, free ends", Rational(3, 10), Polynomial({0, 0, 1}), 1, 2},
      {"edge at the rear", Rational(1, 2), Polynomial({0, Rational(1, 10), Rational(1, 5)}), 1, 1},
      {"edge at the front of a tilted parabola, sliding towards -x", Rational(-2, 5),
       Polynomial({0, Rational(1, 5), Rational(1, 4)}), Rational(3, 4), 1},
      {"two wells, four free ends, sliding towards -x", Rational(-3, 10), Polynomial({0, Rational(1, 10), -4, 0, 6}), 1,
       2}};
  if (context.quick) all.erase(all.begin() + 2, all.end());
  return all;
}

double distance(const Moments& a, const Moments& b, double load) {
  double sum = 0;
  for (std::size_t k = 1; k <= compared_moments; ++k) {
    sum += (a[k] - b[k]) * (a[k] - b[k]) / static_cast<double>(k);
  }
  return std::sqrt(2 * sum / std::numbers::pi) / load;
}

Moments riemann_hilbert_moments(const ContactProblem& problem) {
  const auto solution = solve<double>(problem);
  const Frame& frame = solution->problem().frame();
  const auto unit = to_real<double>(frame.unit);
  const auto origin = to_real<double>(frame.origin);
  Moments result(compared_moments + 1, 0);
  for (const PanelDensity<double>& panel : traction_density(solution->form())) {
    const auto rule = numeric::jacobi_rule<double>(panel.left, panel.right, 48);
    const double length = panel.panel.length;
    const double scale = unit * std::pow(length, panel.left.value + panel.right.value + 1);
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const double y = length * rule.from_left[i];
      const Node<double> node{panel.panel.left + y, y, length * rule.from_right[i]};
      const double x = std::clamp(origin + unit * node.x, -1.0, 1.0);
      const double mass = scale * rule.weights[i] * panel.smooth(node);
      for (std::size_t k = 0; k < result.size(); ++k) result[k] += mass * chebyshev(k, x);
    }
  }
  return result;
}

Moments cell_moments(const ContactProblem& problem, std::size_t cells) {
  using namespace numeric::variational;
  const DiscreteProblem discrete(problem, CellMesh(problem, cells));
  const ActiveSetResult found =
      active_set(discrete, CellSet(cells, 1), {std::vector<double>(cells, 0)}, ActiveSetOptions{});
  DiscreteState state = found.state;
  if (found.outcome != ActiveSetResult::Outcome::solved) {
    const LemkeResult other = lemke(discrete, 100 * static_cast<int>(cells));
    if (!other.reached) throw std::runtime_error("not solved on cells");
    state = other.state;
  }
  const Frame& frame = discrete.mesh().frame();
  const auto origin = to_real<double>(frame.origin);
  const auto unit = to_real<double>(frame.unit);
  const double scale = to_real<double>(problem.load()) / unit;
  Moments result(compared_moments + 1, 0);
  for (std::size_t i = 0; i < cells; ++i) {
    if (state.pressure[i] == 0) continue;
    const double left = std::clamp(origin + unit * discrete.mesh().left(i), -1.0, 1.0);
    const double right = std::clamp(origin + unit * discrete.mesh().right(i), -1.0, 1.0);
    for (std::size_t k = 0; k < result.size(); ++k) {
      result[k] -= scale * state.pressure[i] * (chebyshev_integral(k, right) - chebyshev_integral(k, left));
    }
  }
  return result;
}

Moments displacement_moments(const DualCase& c, int n, const DisplacementFormula& formula) {
  const DisplacementProblem problem(c.s, n, c.height(), to_real<double>(c.load), formula);
  const auto state = problem.by_active_sets(std::vector<char>(static_cast<std::size_t>(n), 1));
  if (!state) throw std::runtime_error("problem I not solved on polynomials");
  return problem.moments(*state, compared_moments);
}

}  // namespace steadyslide::proofs_checks
