#include <cmath>
#include <numbers>

#include "proofs_checks/instruments/cells/cell_law.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::vi_definiteness_lost_graded {
namespace {

/// A fall of s by `step` in the middle of the support.
struct Fall {
  Rational step;
};

std::string text_of(const Fall& fall) { return "s falls by " + to_string(fall.step); }

CaseList<Fall> falls(const Context& context) {
  Random random(context.seed, "vi-definiteness-lost-graded");
  CaseList<Fall> list{{{Rational(3, 10)}},
                      "smallest cell 10 % on either side, ratio 2, seed " + std::to_string(context.seed)};
  while (list.cases.size() < (context.quick ? 3U : 12U)) {
    list.cases.push_back({random.between(Rational(1, 4), Rational(9, 25))});
  }
  return list;
}

CellMesh graded_cells(double smallest) {
  return {cell_problem({{0, 0}, {0}}), Rational(0),
          numeric::variational::graded_edges(-0.5, 0.5, smallest, 2, 0.03125)};
}

double point_value(double smallest) { return largest_point_value(graded_cells(smallest), 0); }

/// The law sup T(0)^2/E = slope log(1/h) + constant, where h is the smallest cell's length divided by the support's.
struct GradedLaw {
  double slope;
  double constant;
  double factor = 0.5;  ///< indefinite if factor (s- - s+) sup T(0)^2/E > 1

  /// Returns the law with the constant measured at two h. Both are at least a thousand times larger than the predicted
  /// critical values: the law is extrapolated.
  static GradedLaw of(double slope) {
    return {slope, (point_value(1e-3) + slope * std::log(1e-3) + point_value(1e-4) + slope * std::log(1e-4)) / 2};
  }
  /// Returns the h at which the symmetric part is semidefinite.
  double critical(const Rational& step) const {
    return std::exp((constant - 1 / (factor * to_real<double>(step))) / slope);
  }
};

void check(Findings& findings, const GradedLaw& law, const Fall& fall) {
  for (const double factor : {1.1, 1 / 1.1}) {
    const double smallest = factor * law.critical(fall.step);
    // Cells cannot be shorter than the smallest numbers.
    findings.require(smallest > 1e-200 && smallest < 1, "no cells have the length " + short_text(smallest));
    const double least = smallest_eigenvalue({{fall.step, 0}, {0}}, graded_cells(smallest));
    check_sign(findings, least, factor > 1, "the smallest cell is " + short_text(smallest) + ", ");
  }
}

}  // namespace

Claim claim() {
  using L = GradedLaw;
  constexpr double slope = 1 / std::numbers::pi;
  return formula_claim<Fall, L>("vi-definiteness-lost-graded")
      .cases(falls)
      .precision(Precision::in_double)
      .says([](const Fall&) { return L::of(slope); })
      .checked(check)
      .wrong("half the slope: `log(1/h)/(2 pi)`", [](L& law) { law = L::of(slope / 2); })
      .wrong("the logarithm alone, no constant", &L::constant, 0)
      .wrong("indefinite where `s` rises instead of falls", [](L& law) { law.factor = -law.factor; })
      .wrong("near miss: `h` foretold a sixth too large", [](L& law) { law.constant += 0.05; })
      .wrong("near miss: `h` foretold a sixth too small", [](L& law) { law.constant -= 0.05; });
}

}  // namespace steadyslide::proofs_checks::vi_definiteness_lost_graded
