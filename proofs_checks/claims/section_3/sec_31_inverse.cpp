#include "proofs_checks/instruments/operators/inverse_operator.hpp"
#include "proofs_checks/instruments/tractions/surface.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::sec_31_inverse {
namespace {

struct PolynomialSlope {
  Rational s;
  Polynomial slope;  ///< u'
};

std::string text_of(const PolynomialSlope& c) { return "s = " + to_string(c.s) + ", u' = " + to_string(c.slope); }

CaseList<PolynomialSlope> slopes(const Context& context) {
  const std::vector<Rational> s{Rational(3, 4), -2, 0, 7, Rational(-1, 5)};
  return random_cases(context, "sec-31-inverse", 10, 1, "polynomials `u` of degree up to 4, `s` of both signs",
                      [&](Random& random, std::size_t k) {
                        const Polynomial slope(random.between(-2, 2, k % 4 + 1));
                        return PolynomialSlope{k < s.size() ? s[k] : random.between(-3, 3), slope};
                      });
}

/// Returns int u T_k/sqrt(1-x^2) dx, k >= 1, as an integral over the angle, for which the midpoint rule is exact.
template <Real R>
R pairing(const Polynomial& slope, int k) {
  using std::cos;
  std::vector<R> u{R(0)};
  for (int n = 0; n <= slope.degree(); ++n) {
    u.push_back(to_real<R>(slope.coefficient(static_cast<std::size_t>(n)) / (n + 1)));
  }
  const int nodes = slope.degree() + k + 4;
  R sum = 0;
  for (int i = 0; i < nodes; ++i) {
    const R angle = numeric::pi<R>() * (2 * i + 1) / (2 * nodes);
    const R x = cos(angle);
    sum += value_of(u, x) * cos(R(k * angle));
  }
  return sum * numeric::pi<R>() / nodes;
}

template <Real R>
void check_inverse(Findings& findings, const InverseFormula& formula, const PolynomialSlope& c, bool quick) {
  using std::abs;
  const JacobiTraction<R> t = inverse_without_integral<R>(c.s, c.slope);
  const PanelDensity<R> traction = density_of(t);
  const InverseOperator<R> inverse(formula, c.slope);
  for (const int percent : {2, 35, 60, 99}) {
    if (quick && percent != 35) continue;
    const auto at = inverse.point(0, R(percent) / 100);
    findings.compare("values", inverse.terms(at).difference(traction(at.node)));
  }
  const R s = to_real<R>(c.s);
  R size = 0;
  for (const R& coefficient : t.factor) size += abs(coefficient);
  for (int k = 1; k <= 4; ++k) {
    findings.compare("weak", R(abs(form_with_chebyshev(t, s, k) - pairing<R>(c.slope, k)) / size));
  }
  // Checks A L(u) = u' and int L(u) = 0.
  const Surface<R> surface{{traction}, {s}, [&c](const R& x) { return value_of(c.slope, x); }, R(0), size};
  check_surface(findings, surface, quick ? 0 : 2);
}

}  // namespace

Claim claim() {
  return formula_claim<PolynomialSlope, InverseFormula>("sec-31-inverse")
      .cases(slopes)
      .effective_where([](const PolynomialSlope& c) { return c.s != 0; })
      .precision(Precision::at_least_fifty)
      .says([](const PolynomialSlope& c) { return InverseFormula::of(c.s); })
      .checked([]<Real R>(Findings& findings, const InverseFormula& formula, const PolynomialSlope& c,
                          const Context& context) { check_inverse<R>(findings, formula, c, context.quick); })
      .wrong("the sign of the integral", [](InverseFormula& l) { l.integral *= -1; })
      .wrong("the sign of `s u'`", [](InverseFormula& l) { l.local *= -1; })
      .wrong("`1/(1+s^2)` missing before the integral", &InverseFormula::integral, 1)
      .wrong("`alpha`'s sign: edges exchanged", [](InverseFormula& l) { std::swap(l.rear, l.front); })
      .wrong("the printed `(1+x)^{1/2}`", &InverseFormula::rear, -half)
      .near_miss("`s u'`", &InverseFormula::local)
      .near_miss("the integral", &InverseFormula::integral);
}

}  // namespace steadyslide::proofs_checks::sec_31_inverse
