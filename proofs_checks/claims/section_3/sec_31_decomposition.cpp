#include "proofs_checks/instruments/tractions/friction_values.hpp"
#include "proofs_checks/instruments/tractions/jacobi_traction.hpp"
#include "proofs_checks/kit/claim_builder.hpp"
#include "proofs_checks/kit/special_numbers.hpp"

namespace steadyslide::proofs_checks::sec_31_decomposition {
namespace {

/// The formulas t_0 = factor (1+x)^left (1-x)^right and b(t_0, t) = constant <<t, 1>>, where b has the friction s.
struct UnitSolution {
  Exponent left;
  Exponent right;
  Number factor;
  Rational s;
  Number constant;
  Number moved = 0;  ///< a near miss adds this to the left power
};

/// Returns -(log 2 + C + (psi(1/2+alpha) + psi(1/2-alpha))/2)/pi with Euler's constant C and the digamma function psi.
Number punch_constant(const Rational& s) {
  const auto plus = to_real<Number>(half + Exponent::angle(s));
  const auto minus = to_real<Number>(half - Exponent::angle(s));
  return -(log(Number(2)) + (digamma(plus) + digamma(minus)) / 2 - digamma(Number(1))) / numeric::pi<Number>();
}

UnitSolution unit_solution(const FrictionValue& c) {
  const Exponent alpha = Exponent::angle(c.s);
  return {-(half + alpha), -(half - alpha), cos_pi_alpha<Number>(c.s) / numeric::pi<Number>(), c.s,
          punch_constant(c.s)};
}

template <Real R>
void check(Findings& findings, const UnitSolution& form, bool quick) {
  using std::abs;
  const R s = to_real<R>(form.s);
  const R constant(form.constant);
  JacobiTraction<R> t{numeric::Power<R>::of(form.left), numeric::Power<R>::of(form.right), {R(form.factor)}};
  t.left.value += R(form.moved);
  t.left.plus_one += R(form.moved);
  for (int k = 1; k <= 4; ++k) findings.compare("zero", static_cast<double>(abs(form_with_chebyshev(t, s, k))));
  findings.compare<R>("mean", integral(t), R(1));
  for (int m = 0; m <= (quick ? 0 : 3); ++m) {
    const R whole = m % 2 == 0 ? R(2) / (m + 1) : R(0);
    findings.compare("powers", static_cast<double>(abs(form_with_power(t, s, m) - constant * whole)));
  }
}

}  // namespace

Claim claim() {
  return formula_claim<FrictionValue, UnitSolution>("sec-31-decomposition")
      .cases([](const Context& context) { return frictions_of_both_signs(context, "sec-31-decomposition"); })
      .precision(Precision::at_least_fifty)
      .says(unit_solution)
      .checked([]<Real R>(Findings& findings, const UnitSolution& form, const FrictionValue&, const Context& context) {
        check<R>(findings, form, context.quick);
      })
      .wrong("`alpha`'s sign in `t_0`", [](UnitSolution& form) { std::swap(form.left, form.right); })
      .wrong("arguments exchanged: b(t_hat, t_0)", [](UnitSolution& form) { form.s *= -1; })
      .wrong("`t_0` of the frictionless punch", [](UnitSolution& form) { form.left = form.right = -half; })
      .wrong("`cos(pi alpha)` missing", &UnitSolution::factor, 1 / numeric::pi<Number>())
      .wrong("`b(t_0, t) = 0` for all `t`", &UnitSolution::constant, 0)
      .wrong("`K = log 2/pi` whatever the friction", &UnitSolution::constant, punch_constant(0))
      .near_miss("`K`", [](UnitSolution& form, const Number& step) { form.constant += step; })
      .near_miss("ten times an exponent", [](UnitSolution& form, const Number& step) { form.moved = 10 * step; });
}

}  // namespace steadyslide::proofs_checks::sec_31_decomposition
