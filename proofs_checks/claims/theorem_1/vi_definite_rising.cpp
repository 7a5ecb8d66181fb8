#include "proofs_checks/instruments/cells/cell_law.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/cells/dense_algebra.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::vi_definite_rising {
namespace {

struct JumpsOnCells {
  CellFrictionSteps steps;
  CellMesh mesh;
};

std::string text_of(const JumpsOnCells& c) {
  return text_of(c.steps) + ", " + std::to_string(c.mesh.size()) + " cells";
}

/// Returns in turn one jump down or up, and one to four jumps with this trend.
auto jumps(Trend several) {
  const auto make = [several](Random& random, std::size_t k) {
    constexpr std::array<Cells, 3> kinds{Cells::equal, Cells::unequal, Cells::graded};
    CellFrictionSteps steps = k % 2 == 0 ? random_steps(random, k % 4 == 0 ? Trend::falling : Trend::rising, 3, 1)
                                         : random_steps(random, several, 3, 4);
    if (random.below(2) == 0) steps = mirrored(steps);
    const ContactProblem problem = cell_problem(steps);
    const std::size_t cells = 10 + random.below(20);
    return JumpsOnCells{steps, random_cells(random, problem, kinds[k % 3], cells)};
  };
  return [make](const Context& context) {
    return random_cases(context, "vi-definite-rising", 60, 9, "random meshes and frictions", make);
  };
}

/// Returns the smallest eigenvalue lambda of (symmetric part) - lambda (logarithm) on zero mean.
Values measured(const JumpsOnCells& c) {
  const auto b = operator_of(c.steps, c.mesh);
  const double least =
      eigenvalues(on_zero_mean(symmetric_part(c.mesh, b, true)), on_zero_mean(symmetric_part(c.mesh, b, false)))(0);
  if (c.steps.jumps.size() == 1) return {{"one", least}};
  return {{"several", std::max(1 - least, 0.0)}};
}

/// Returns min(1, 1 + factor (s+ - s-) sup T(c)^2/E), where E is the energy of the logarithm.
Values predicted(const JumpsOnCells& c, double factor, bool zero_mean = true) {
  if (c.steps.jumps.size() > 1) return {{"several", 0.0}};
  const Eigen::MatrixXd logarithm = symmetric_part(c.mesh, operator_of(c.steps, c.mesh), false);
  const double largest = largest_point_value(logarithm, weights_of(c.mesh, c.mesh.place(c.steps.jumps[0])), zero_mean);
  const auto step = to_real<double>(c.steps.s[1] - c.steps.s[0]);
  return {{"one", std::min(1.0, 1 + factor * step * largest)}};
}

}  // namespace

Claim claim() {
  return compared<JumpsOnCells>("vi-definite-rising")
      .cases(jumps(Trend::rising))
      .precision(Precision::in_double)
      .measured(measured)
      .predicted([](const JumpsOnCells& c) { return predicted(c, 0.5); })
      .wrong("the jump without the factor 1/2", [](Values& p, const JumpsOnCells& c) { p = predicted(c, 1); })
      .wrong("`s_- - s_+` instead of `s_+ - s_-`", [](Values& p, const JumpsOnCells& c) { p = predicted(c, -0.5); })
      .wrong("the supremum over all tractions, not those of zero mean",
             [](Values& p, const JumpsOnCells& c) { p = predicted(c, 0.5, false); })
      .wrong_beyond("several jumps, falling instead of rising", jumps(Trend::falling))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::vi_definite_rising
