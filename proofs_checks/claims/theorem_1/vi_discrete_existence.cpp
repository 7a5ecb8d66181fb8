#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/variational/certificate.hpp"
#include "numeric/variational/lemke.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::vi_discrete_existence {
namespace {

/// Returns the limit for pivots. With short cells and strong friction the paths change direction very often: of 1800
/// random problems 30 take more than 100 n pivots, and the longest takes 168 000 with 30 cells. A path that is not
/// followed to its end shows nothing.
int most_pivots(const DiscreteProblem& problem) { return 2000 * static_cast<int>(problem.size()); }

/// Changes of the operator's entries, and of the pressures that the certificate receives.
struct Variant {
  int logarithm = 1;
  bool from_left = false;  ///< int s p from the left end for both signs of s
  double unit = 1;         ///< unit of length, divided by the support's length
  double moved = 0;        ///< change of the pressures, in units of the certificate's tolerance
};

struct Numbered {
  std::string name;
  ProblemOnCells on_cells;
};

CaseList<Numbered> problems(const Context& context) {
  return random_cases(context, "vi-discrete-existence", 300, 12,
                      "random meshes, frictions up to `s = 20`, profiles and loads, one in four tilting",
                      [](Random& random, std::size_t k) {
                        // Weak and strong friction: the largest s is between 1/5 and 20.
                        const Rational largest = k % 2 == 0 ? random.between(Rational(1, 5), 2) : random.between(2, 20);
                        ProblemOnCells on_cells = random_problem_on_cells(random, k, Trend::any, largest, true);
                        return Numbered{"problem " + std::to_string(k) + ": " + text_of(on_cells), on_cells};
                      });
}

void check(Findings& findings, const Variant& variant, const Numbered& c) {
  const DiscreteProblem problem(c.on_cells.problem, c.on_cells.mesh);
  const GalerkinOperator& b = problem.galerkin_operator();
  double least = 0;
  double most = 0;
  double diagonal = HUGE_VAL;
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      double slip = b.friction_entry(i, j);
      if (variant.from_left && b.friction().sign < 0) {
        slip = j < i ? b.friction().whole[j] : i == j ? b.friction().whole[i] + b.friction().own[i] : 0;
      }
      const double shift = problem.mesh().length(j) * std::log(variant.unit) / std::numbers::pi;
      const double entry = variant.logarithm * b.kernel_entry(i, j) + shift + slip;
      least = std::min(least, entry);
      most = std::max(most, entry);
      if (i == j) diagonal = std::min(diagonal, entry);
    }
  }
  findings.compare("entries", -least / most);
  findings.require(diagonal > 0, "an entry of the diagonal is not positive");

  const auto found = numeric::variational::lemke(problem, most_pivots(problem));
  if (!found.reached) return findings.skip("residual");
  const double allowed = certify(problem, found.state).allowed;
  DiscreteState state = found.state;
  for (double& p : state.pressure) p *= 1 + variant.moved * allowed;
  const auto certificate = certify(problem, state);
  const double largest =
      std::max({certificate.natural, certificate.equation, certificate.load, certificate.moment, certificate.product});
  findings.compare("residual", largest / allowed);
}

}  // namespace

Claim claim() {
  return formula_claim<Numbered, Variant>("vi-discrete-existence")
      .cases(problems)
      .precision(Precision::in_double)
      .checked(check)
      .wrong("the logarithm with the other sign", &Variant::logarithm, -1)
      .wrong("negative `s` integrated from the left end", &Variant::from_left, true)
      .wrong("lengths in units of half the support's", &Variant::unit, 0.5)
      .wrong("near miss: pressures moved by ten times what the certificate allows", &Variant::moved, 10);
}

}  // namespace steadyslide::proofs_checks::vi_discrete_existence
