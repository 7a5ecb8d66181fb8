// A row of flat punches with the period 2 pi: (1/2) cot((x'-x)/2) for 1/(x'-x). With y = tan(x/2), x in ]-pi, pi[,
//
//   (1/2) cot((x'-x)/2) dx' = dy'/(y'-y) - y' dy'/(1+y'^2),   dx = 2 dy/(1+y^2),   1/(y'-i) = (y'+i)/(1+y'^2),
//
// so that the equation is A t = m with m = (1/pi) int y' t/(1+y'^2) dy' = Re F(i), and int t dx = 2 pi Im F(i). Angles x/2 are
// those of a friction y = tan(x/2): cos(x/2) = 1/r. [Bal16, remark 2]

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// Cosine and sine of a sum of half angles.
struct HalfAngle {
  HalfAngle(const PhaseField& field, const AngleForm& form)
      : cos((field.phase(form, 1) + field.phase(form, -1)) / 2),
        sin((field.phase(form, 1) - field.phase(form, -1)) / (2 * field.i())) {}
  ex cos, sin;
};

DecidedStatement row_kernel() {
  const PhaseField field({symbol("y"), symbol("y1")});  // at x and x'
  const auto& at = field.friction(0);
  const ex y = at.s;
  const ex y1 = field.friction(1).s;
  const auto decided = [&](const std::string& words, int sign, const ex& rate, int bank) {
    const HalfAngle difference(field, AngleForm(0, {{1, 1}, {0, -1}}));
    const ex i = field.i();
    // cot = cos/sin, both sides times sin, y'-y and 1+y'^2.
    return Comparison(field)
        .equal("dy/dx", (at.cos * at.cos + at.sin * at.sin) / (2 * at.cos * at.cos), rate)
        .equal("kernel", difference.cos * (y1 - y), difference.sin * (1 + y1 * y1 - sign * y1 * (y1 - y)))
        .equal("1/(y'-i)", (y1 + bank * i) * (y1 - i), 1 + y1 * y1)
        .as(words);
  };
  const ex rate = (1 + y * y) / 2;
  return {"rh-row-kernel",
          decided("with y = tan(x/2): dy/dx = (1+y^2)/2, (1/2) cot((x'-x)/2) dx' = dy'/(y'-y) - y' dy'/(1+y'^2), "
                  "1/(y'-i) = (y'+i)/(1+y'^2)",
                  1, rate, 1),
          {decided("+ y' dy'/(1+y'^2)", -1, rate, 1), decided("without y' dy'/(1+y'^2)", 0, rate, 1),
           decided("y = tan(x)", 1, 2 * rate, 1), decided("(y'-i)/(1+y'^2)", 1, rate, -1)}};
}

/// y - y_j and i - y_j by half angles; then with D = prod cos(x_j/2)^{p_j}, sum p_j = -1, h = sum p_j x_j/2 and M = prod
/// |sin((x-x_j)/2)|^{p_j}: D |Y(y)| = M cos(x/2), D Y(i) = exp(i h)/i, and B = D b.
DecidedStatement row_form() {
  const PhaseField field({symbol("y"), symbol("y_j"), symbol("tan_h")});
  const auto& at = field.friction(0);
  const auto& place = field.friction(1);
  const auto& shift = field.friction(2);
  const ex i = field.i();
  const symbol load("P"), pi("pi"), m("M"), cosine("cos");
  const auto decided = [&](const std::string& words, int turned, int half, bool sine) {
    const HalfAngle distance(field, AngleForm(0, {{0, 1}, {1, -1}}));
    const HalfAngle moved(field, AngleForm(0, {{0, 1}, {2, turned}}));
    const auto b = [&](const ex& y) -> ex { return -load / (2 * pi) * (shift.cos - y * shift.sin); };
    const ex value_at_i = (shift.cos + i * shift.sin) / i;
    return Comparison(field)
        .equal("y - y_j", distance.sin, (at.s - place.s) * at.cos * place.cos)
        .equal("i - y_j", (i - place.s) * place.cos, i * (place.cos + i * place.sin))
        .equal("Y B at i", value_at_i * b(i), i * load / (half * pi))
        .equal("t", cosine * m * at.cos * b(at.s), -load / (2 * pi) * cosine * m * (sine ? moved.sin : moved.cos))
        .as(words);
  };
  return {"rh-row-form",
          decided("cos(pi alpha) |Y| B, B linear with Y B = i P/(2 pi) at i, is -(P/(2 pi)) cos(pi alpha) prod_j "
                  "|sin((x-x_j)/2)|^{p_j} cos((x + sum_j p_j x_j)/2)",
                  1, 2, false),
          {decided("cos((x - sum_j p_j x_j)/2)", -1, 2, false), decided("cos(x/2)", 0, 2, false),
           decided("i P/pi at i", 1, 1, false), decided("a sine", 1, 2, true)}};
}

/// A linear B is (m/Y)_{poly} and a constant: F = m - Y B is O(1/z), Y of the order -1.
DecidedStatement row_candidate() {
  const PhaseField field;
  const symbol slope("m"), a("a"), x("y");
  const std::vector<ex> sums = power_sum_symbols(1);
  const auto decided = [&](const std::string& words, const ex& first, int order) {
    const std::vector<ex> y = series_at_infinity(sums, -1, 1);
    return Comparison(field)
        .equal("F far away, constant", field_coefficient(order, {slope}, {a, first}, y, 0), 0)
        .equal("B", PolynomialSlope(-1, {slope}, sums, slope * sums[0] - a).factor(x), a + first * x)
        .as(words);
  };
  return {"rh-row-candidate",
          decided("B = a + m y is the polynomial part of m/Y and a constant, for any a", slope, -1),
          {decided("2 m", 2 * slope, -1), decided("-m", -slope, -1), decided("without m", 0, -1),
           decided("m + 1", slope + 1, -1)}};
}

}  // namespace

void add_rows(std::vector<DecidedStatement>& all) {
  for (const auto& statement : {row_kernel, row_form, row_candidate}) all.push_back(statement());
}

}  // namespace steadyslide::symbolic
