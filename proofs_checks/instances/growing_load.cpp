#include <algorithm>
#include <cmath>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "proofs_checks/instances/solved_instances.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"

namespace steadyslide::proofs_checks {
namespace {

using Solution = std::shared_ptr<const numeric::ContactSolution<double>>;

Solution solved(const ContactProblem& problem) {
  Solution solution = numeric::riemann_hilbert<double>(problem).solution;
  return solution && solution->failed_condition().empty() ? solution : nullptr;
}

/// True if x is inside the contact, at least 1/20 away from its ends and from all jumps.
bool is_inside(double x, const Solution& solution, const std::vector<Rational>& jumps) {
  constexpr double apart = 0.05;
  const auto is_near = [&](const Rational& c) { return std::abs(x - to_real<double>(c)) < apart; };
  const auto contains = [&](const auto& part) {
    return part.left.x.value + apart < x && x < part.right.x.value - apart;
  };
  return std::ranges::none_of(jumps, is_near) && std::ranges::any_of(solution->contact(), contains);
}

}  // namespace

std::vector<Instance> growing_load() {
  std::vector<Instance> all;
  Random random(2016, "growing-load");
  for (std::size_t k = 0; k < 12; ++k) {
    CellFrictionSteps steps = random_steps(random, Trend::any, 3, 3);
    if (k % 2 == 1) steps = mirrored(steps);
    const ContactProblem problem =
        cell_problem(steps, random_profile(random, k % 3 != 0), random.between(Rational(1, 10), 1));
    const Solution before = solved(problem);
    const Solution after = solved(problem.with_load(problem.load() * Rational(1001, 1000)));
    if (!before || !after || before->contact().size() != after->contact().size()) continue;
    const double growth = to_real<double>(problem.load()) / 1000;
    double change = -std::numeric_limits<double>::infinity();
    for (int j = -40; j <= 40; ++j) {
      const Rational x(j, 41);
      if (!is_inside(to_real<double>(x), before, steps.jumps)) continue;
      change = std::max(change, (after->at(x).traction.left.value - before->at(x).traction.left.value) / growth);
    }
    double left = -std::numeric_limits<double>::infinity();
    double right = std::numeric_limits<double>::infinity();
    const auto parts = before->contact();
    const auto later = after->contact();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].left.kind == SingularKind::free)
        left = std::max(left, (later[i].left.x.value - parts[i].left.x.value) / growth);
      if (parts[i].right.kind == SingularKind::free)
        right = std::min(right, (later[i].right.x.value - parts[i].right.x.value) / growth);
    }
    if (!std::isfinite(change) || !std::isfinite(left) || !std::isfinite(right)) continue;
    all.push_back({{{"P", Real50(to_real<double>(problem.load()))},
                    {"dT", change},
                    {"left", left},
                    {"right", right},
                    {"accuracy", Real50("1e-8")}}});
  }
  return all;
}

}  // namespace steadyslide::proofs_checks
