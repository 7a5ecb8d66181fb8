#include "numeric/cauchy/residuals.hpp"
#include "proofs_checks/instruments/operators/inverse_operator.hpp"
#include "proofs_checks/instruments/tractions/friction_values.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_10_proof_linear {
namespace {

/// The traction (a + b (1+x)) t_0, t_0 = cos(pi alpha)/pi (1+x)^rear (1-x)^front.
struct LinearForm {
  Number a;
  Number b;
  Exponent rear;
  Exponent front;
};

const Rational k(3, 2);

/// Returns a = -pi k (1 - times alpha).
Number constant(const FrictionValue& c, int times) {
  const auto alpha = to_real<Number>(Exponent::angle(c.s));
  return -numeric::pi<Number>() * to_real<Number>(k) * (1 - times * alpha);
}

}  // namespace

Claim claim() {
  return formula_claim<FrictionValue, LinearForm>("thm-10-proof-linear")
      .cases([](const Context& context) { return friction_values(context, "thm-10-proof-linear"); })
      .effective_where([](const FrictionValue& c) { return is_coupled(c); })
      .precision(Precision::quick_in_double)
      .says([](const FrictionValue& c) {
        const Exponent alpha = Exponent::angle(c.s);
        return LinearForm{constant(c, 2), numeric::pi<Number>() * to_real<Number>(k), -(half + alpha), -(half - alpha)};
      })
      .checked([]<Real R>(Findings& findings, const LinearForm& form, const FrictionValue& c) {
        using std::abs, std::max, std::pow;
        const R slope = to_real<R>(k);
        const R a(form.a), b(form.b);
        const R size = cos_pi_alpha<R>(c.s) / numeric::pi<R>();
        const auto slope_at = [slope](const auto&...) { return slope; };
        const InverseOperator<R> inverse(c.s, {{R(-1), R(2), {R(0), R(1)}, {R(0), R(1)}, slope_at}});
        for (const int percent : {30, 2}) {
          const auto at = inverse.point(0, R(percent) / 100);
          const R& d = at.node.from_left;
          const R unit = size * pow(d, to_real<R>(form.rear)) * pow(at.node.from_right, to_real<R>(form.front));
          const R found = inverse.at(at);
          findings.compare("formula", found, R((a + b * d) * unit), max(R(abs(found)), R(abs(b) * unit / 100)));
        }
        const PanelDensity<R> panel{{R(-1), R(1), R(2)},
                                    numeric::Power<R>::of(form.rear),
                                    numeric::Power<R>::of(form.front),
                                    [=](const auto& node) { return R(size * (a + b * node.from_left)); }};
        const numeric::SurfaceCheck<R> check({panel}, {to_real<R>(c.s)}, slope_at);
        findings.compare("equation", static_cast<double>(check.equation()));
      })
      .wrong("the sign of a", [](LinearForm& form) { form.a = -form.a; })
      .wrong("`alpha`'s sign in `a`", [](LinearForm& form, const FrictionValue& c) { form.a = constant(c, -2); })
      .wrong("`alpha` for `2 alpha` in `a`", [](LinearForm& form, const FrictionValue& c) { form.a = constant(c, 1); })
      .wrong("`pi` missing",
             [](LinearForm& form) {
               form.a /= numeric::pi<Number>();
               form.b /= numeric::pi<Number>();
             })
      .wrong("the printed `(1+x)^{1/2}` in `t_0`", &LinearForm::rear, -half)
      .near_miss("a", &LinearForm::a)
      .near_miss("`b`", &LinearForm::b);
}

}  // namespace steadyslide::proofs_checks::thm_10_proof_linear
