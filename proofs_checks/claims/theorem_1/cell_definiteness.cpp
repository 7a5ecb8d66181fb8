// Where the symmetric part of the operator on cells is positive definite on tractions of zero mean.

#include <Eigen/Eigenvalues>
#include <cmath>

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/cell_law.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::variational::CellMesh;
using numeric::variational::GalerkinOperator;

/// The smallest eigenvalue of (symmetric part) - lambda (logarithm) on zero mean, one jump of friction:
/// 1 + factor (s+ - s-) sup T(c)^2/E, E the logarithm's energy, or 1.
struct PencilSaid {
  double factor = 0.5;
  double moved = 0;
  bool zero_mean = true;          ///< the supremum over these tractions only
  Trend several = Trend::rising;  ///< the jumps, where there are several
};

std::vector<Evidence> check_pencil(const Context& context, const PencilSaid& said) {
  const Quantity one{"smallest eigenvalue relative to E, one jump",
                     {"eigenvalues of the matrix of entries", "1 + (s_+ - s_-) sup(T(c)^2/E)/2"},
                     tolerance<double>()};
  const Quantity all{"how far the smallest eigenvalue relative to E is below 1, s nondecreasing",
                     {"eigenvalues of the matrix of entries", "0, from the energy's formula"},
                     tolerance<double>()};
  return gather([&] {
    Random random(context.seed, "vi-definite-rising");
    Findings findings;
    constexpr std::array<Cells, 3> kinds{Cells::equal, Cells::unequal, Cells::graded};
    const std::size_t count = context.quick ? 9 : 60;
    for (std::size_t k = 0; k < count; ++k) {
      const bool single = k % 2 == 0;
      CellFrictionSteps steps = single ? random_steps(random, k % 4 == 0 ? Trend::falling : Trend::rising, 3, 1)
                                       : random_steps(random, said.several, 3, 4);
      if (random.below(2) == 0) steps = mirrored(steps);
      const ContactProblem problem = cell_problem(steps);
      const CellMesh mesh = random_cells(random, problem, kinds[k % 3], 10 + random.below(20));
      const GalerkinOperator b = operator_of(steps, mesh);
      const Eigen::MatrixXd logarithm = symmetric_part(mesh, b, false);
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> pencil(
          on_zero_mean(symmetric_part(mesh, b, true)), on_zero_mean(logarithm), Eigen::EigenvaluesOnly);
      const double least = pencil.eigenvalues()(0);
      findings.begin_case(text_of(steps) + ", " + std::to_string(mesh.size()) + " cells");
      if (!single) {
        findings.compare(all, std::max(0.0, 1 - least));
        continue;
      }
      const double step = numeric::to_real<double>(steps.s[1] - steps.s[0]);
      const double largest =
          largest_point_value(logarithm, weights_of(mesh, mesh.place(steps.jumps[0])), said.zero_mean);
      const double expected = std::min(1.0, 1 + said.factor * step * largest) + said.moved;
      findings.compare(one, std::abs(least - expected) / std::max(1.0, std::abs(expected)));
    }
    return findings.evidence("random meshes and frictions, seed " + std::to_string(context.seed));
  });
}

}  // namespace

std::vector<Claim> cell_definiteness_claims() {
  using P = PencilSaid;
  std::vector<Claim> claims;
  claims.push_back(make_claim(
      claim_text("vi-definite-rising"), check_pencil, P(),
      std::vector<Wrong<P>>{
          {"several jumps, falling instead of rising", changed<P>([](P& said) { said.several = Trend::falling; })},
          {"the jump without the factor 1/2", changed<P>([](P& said) { said.factor = 1; })},
          {"s_- - s_+ instead of s_+ - s_-", changed<P>([](P& said) { said.factor = -0.5; })},
          {"the supremum over all tractions, not those of zero mean",
           changed<P>([](P& said) { said.zero_mean = false; })},
          {"near miss: the eigenvalue moved by ten times the tolerance",
           changed<P>([](P& said) { said.moved = near_miss<double>(); })}}));
  return claims;
}

}  // namespace steadyslide::proofs_checks
