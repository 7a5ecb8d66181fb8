#include "proofs_checks/instruments/tractions/friction_values.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_10_proof_splitting {
namespace {

/// The formula (1+x')^{1+b} = (constant + slope x) (1+x')^b + last (x'-x) (1+x')^{b + last_power}.
struct Splitting {
  Rational constant = 1;
  Rational slope = 1;
  Rational last = 1;
  int last_power = 0;
  Number integral = 1;  ///< factor of the second integral
};

/// Returns (1+x')^{b + extra} eta(x') with b = 1/2+alpha, eta = (1-x')^{1/2-alpha}/(3+x').
template <Real R>
PiecewiseDensity<R> density(const Rational& s, int extra) {
  const Exponent alpha = Exponent::angle(s);
  return {{{R(-1), R(1), R(2)},
           numeric::Power<R>::of(half + alpha + Exponent(extra)),
           numeric::Power<R>::of(half - alpha),
           [](const Node<R>& node) { return R(1 / (3 + node.x)); }}};
}

/// Decides an equation of first degree in x and in x': the four corners of a rectangle are sufficient.
void decide_powers(Findings& findings, const Splitting& form) {
  for (const Rational& x : {Rational(-1, 2), Rational(1, 3)}) {
    for (const Rational& y : {Rational(1, 5), Rational(-2, 3)}) {
      findings.decide("`1+x' = (1+x) + (x'-x)`, the common factor `(1+x')^b` taken out",
                      1 + y == form.constant + form.slope * x + form.last * (y - x));
    }
  }
}

}  // namespace

Claim claim() {
  return formula_claim<FrictionValue, Splitting>("thm-10-proof-splitting")
      .cases([](const Context& context) { return friction_values(context, "thm-10-proof-splitting"); })
      .precision(Precision::quick_in_double)
      .checked([]<Real R>(Findings& findings, const Splitting& form, const FrictionValue& c) {
        using std::abs;
        decide_powers(findings, form);
        const trapezoidal::Grid<R> grid(density<R>(c.s, 0));
        const auto at = grid.midpoint_near(0, R(3) / 10);
        const R left = tanh_sinh::hilbert<R>(density<R>(c.s, 1), at).value;
        const R before = to_real<R>(form.constant - form.slope) + to_real<R>(form.slope) * at.node.from_left;
        const R second = before * R(form.integral) * grid.hilbert(at);
        const R last = to_real<R>(form.last) / numeric::pi<R>() *
                       trapezoidal::Grid<R>(density<R>(c.s, form.last_power)).integral();
        findings.compare("integral", left, R(second + last), abs(second));
      })
      .wrong("the last term's sign", &Splitting::last, -1)
      .wrong("`1+x` missing before the second term", &Splitting::slope, 0)
      .wrong("another power in the last term", &Splitting::last_power, 1)
      .near_miss("the second integral", [](Splitting& form, const Number& step) { form.integral += step; });
}

}  // namespace steadyslide::proofs_checks::thm_10_proof_splitting
