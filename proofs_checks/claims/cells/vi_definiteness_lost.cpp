#include <cmath>

#include "proofs_checks/instruments/cells/cell_law.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::vi_definiteness_lost {
namespace {

/// A fall of s by `step` at c on `cells` equal cells. Without a step: the rate at which sup T(c)^2/E for c = 0 tends to
/// its law, on 16 to `cells` cells.
struct Fall {
  Rational step;
  Rational c;
  std::size_t cells;
};

std::string text_of(const Fall& fall) {
  const std::string cells = std::to_string(fall.cells) + " equal cells";
  if (fall.step == 0) return "jump in the middle, up to " + cells;
  return "s falls by " + to_string(fall.step) + " at " + to_string(fall.c) + ", " + cells;
}

/// The law: the form is indefinite if (s- - s+) sup(T(c)^2/E)/2 > 1.
struct DefinitenessLaw {
  PointValueLaw largest;
  double factor = 0.5;

  bool definite(const Fall& fall) const {
    const auto cells = static_cast<double>(fall.cells);
    return factor * to_real<double>(fall.step) * largest(cells, to_real<double>(fall.c)) < 1;
  }
};

/// Returns cases with ten per cent fewer and ten per cent more cells than the law predicts.
CaseList<Fall> falls(const Context& context) {
  Random random(context.seed, "vi-definiteness-lost");
  CaseList<Fall> list{{}, "falling jumps, `N` 10 % on either side, seed " + std::to_string(context.seed)};
  const PointValueLaw law;
  const auto both_sides = [&](const Rational& step, const Rational& place) {
    const double limit = 2 / to_real<double>(step);
    const auto c = to_real<double>(place);
    for (const double factor : {0.9, 1.1}) {
      const auto cells = 2 * static_cast<std::size_t>(std::lround(factor * law.cells(limit, c) / 2));
      // A jump inside a cell has less effect than one between two cells. The law gives the difference.
      if (std::abs(law(static_cast<double>(cells), c) - limit) > 0.02) list.cases.push_back({step, place, cells});
    }
  };
  both_sides(1, 0);
  list.cases.push_back({0, 0, context.quick ? std::size_t{128} : std::size_t{1024}});
  if (!context.quick) both_sides(Rational(7, 10), 0);
  for (std::size_t k = 0; k < (context.quick ? 4U : 20U); ++k) {
    const Rational place = random.between(Rational(-1, 2), Rational(1, 2));
    both_sides(random.between(Rational(9, 10), Rational(5, 4)), place);
  }
  return list;
}

/// Checks that the law's error falls with the length of the cells.
void check_rate(Findings& findings, const PointValueLaw& law, std::size_t most) {
  double before = 0;
  double rate = 0;
  double rate_before = 0;
  for (std::size_t n = 16; n <= most; n *= 2) {
    const double error =
        std::abs(largest_point_value(CellMesh(cell_problem({{0, 0}, {0}}), n), 0) - law(static_cast<double>(n), 0));
    if (n > 16) {
      rate_before = rate;
      rate = std::log2(before / error);
      findings.require(std::abs(rate - 1) <= 0.15, "on " + std::to_string(n) +
                                                       " cells the error of sup T(c)^2/E falls with the power " +
                                                       short_text(rate) + " of the cells' length, not with the first");
    }
    before = error;
  }
  findings.measure(
      {"distance of `sup(T(c)^2/E)` on `N` equal cells from its law, as a power of `1/N`", rate,
       std::abs(rate - rate_before), 1, 0.1,
       "`N = 16` to " + std::to_string(most) + ", doubled; the last rate, and how far the one before is off it"});
}

void check(Findings& findings, const DefinitenessLaw& law, const Fall& fall) {
  if (fall.step == 0) {
    check_rate(findings, law.largest, fall.cells);
    return;
  }
  const CellFrictionSteps steps{{fall.step, 0}, {fall.c}};
  const CellMesh mesh(cell_problem(steps), fall.cells);
  check_sign(findings, smallest_eigenvalue(steps, mesh), law.definite(fall), "");
}

}  // namespace

Claim claim() {
  using L = DefinitenessLaw;
  return formula_claim<Fall, L>("vi-definiteness-lost")
      .cases(falls)
      .precision(Precision::in_double)
      .checked(check)
      .wrong("half the slope: `log(N)/(2 pi)`", [](L& law) { law.largest.slope /= 2; })
      .wrong("the logarithm alone, no constant", [](L& law) { law.largest.constant = false; })
      .wrong("indefinite where `s` rises instead of falls", [](L& law) { law.factor = -law.factor; })
      .wrong("`Lambda = phi`, as without cells", [](L& law) { law.largest.cells_form = false; })
      .wrong("near miss: the constant moved by 1/1000", [](L& law) { law.largest.moved = 1e-3; });
}

}  // namespace steadyslide::proofs_checks::vi_definiteness_lost
