// Solves each problem independently for two loads and checks that the contact set under the smaller load is part of
// that under the larger one.

#include <algorithm>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::load_monotone_solved {
namespace {

struct TwoLoads {
  CellFrictionSteps steps;
  Polynomial profile;
  Rational load;
  Rational growth;
  std::optional<Rational> load_at = {};

  ContactProblem problem(const Rational& factor) const { return cell_problem(steps, profile, load * factor, load_at); }
};

std::string text_of(const TwoLoads& c) {
  return text_of(c.steps) + ", loads " + to_string(c.load) + " and " + to_string(Rational(c.load * c.growth));
}

auto loads(const std::optional<Rational>& growth) {
  return [growth](const Context& context) {
    return random_cases(context, "load-monotone-solved", 60, 6, "random frictions, profiles and loads",
                        [&](Random& random, std::size_t k) {
                          CellFrictionSteps steps = random_steps(random, Trend::any, 3, 3);
                          if (random.below(2) == 0) steps = mirrored(steps);
                          const Polynomial profile = random_profile(random, k % 3 == 0);
                          const Rational load = random.between(Rational(1, 50), 3);
                          const Rational larger = 1 + random.between(Rational(1, 50), 2);
                          return TwoLoads{steps, profile, load, growth.value_or(larger)};
                        });
  };
}

/// Returns a profile with two bumps; the load acts close to the right one.
CaseList<TwoLoads> tilting(const Context&) {
  return {{{{{0, 0}, {0}}, Polynomial({0, 0, Rational(-9, 10), 0, 1}), Rational(13, 10), 3, Rational(5, 8)}},
          "two bumps"};
}

using Solution = std::shared_ptr<const numeric::ContactSolution<double>>;

/// Returns null if the solution does not meet all conditions.
Solution solved(const ContactProblem& problem) {
  Solution solution = numeric::riemann_hilbert<double>(problem).solution;
  return solution && solution->failed_condition().empty() ? solution : nullptr;
}

/// Returns the part of the first contact set that is not in the second.
double lost(const Solution& small, const Solution& large) {
  double rest = 0;
  for (const auto& part : small->contact()) {
    double covered = 0;
    for (const auto& other : large->contact()) {
      covered += std::max(
          0.0, std::min(part.right.x.value, other.right.x.value) - std::max(part.left.x.value, other.left.x.value));
    }
    rest += part.right.x.value - part.left.x.value - covered;
  }
  return std::max(rest / 2, 0.0);
}

double fall(const Solution& small, const Solution& large, const Rational& load) {
  double most = 0;
  for (int k = -49; k < 50; ++k) {
    const Rational x(2 * k + 1, 101);  // not a point of the problem's data
    most = std::max(most, large->at(x).traction.left.value - small->at(x).traction.left.value);
  }
  return most * 2 / to_real<double>(load);
}

}  // namespace

Claim claim() {
  return compared<TwoLoads>("load-monotone-solved")
      .cases(loads({}))
      .precision(Precision::in_double)
      .measured([](const TwoLoads& c) -> Values {
        const Solution small = solved(c.problem(1));
        const Solution large = solved(c.problem(c.growth));
        if (!small || !large) return {};
        return {{"lost", lost(small, large)}, {"fall", fall(small, large, c.load)}};
      })
      .predicted([](const TwoLoads&) -> Values {
        return {{"lost", 0.0}, {"fall", 0.0}};
      })
      .wrong_beyond("the smaller load taken for the larger one", loads(Rational(1, 2)))
      .wrong_beyond("an indenter that may tilt", tilting)
      .wrong_beyond("near miss: the larger load less by a millionth", loads(1 - Rational(1, 1'000'000)))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::load_monotone_solved
