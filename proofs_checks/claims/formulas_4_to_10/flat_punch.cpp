// The flat punch under constant friction. [Bal16, (4), (8)]

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

std::vector<ContactProblem> grid() {
  std::vector<ContactProblem> problems;
  for (const Rational& nu : {Rational(3, 10), Rational(-9, 10), Rational(0), Rational(499, 1000)}) {
    for (const Rational& f : {Rational(1), Rational(1, 5), Rational(10), Rational(50), Rational(0)}) {
      problems.push_back(punch(nu, {f}, {}, Rational(7, 3)));
    }
  }
  return problems;
}

/// -+ amplitude (1+x)^{-(1/2+alpha)} (1-x)^{-(1/2-alpha)}.
PunchFormula on_the_whole_punch(Rational (*factor)(const ContactProblem&)) {
  return PunchFormula::from([factor]<Real R>(const ContactProblem& p) {
    const R size = numeric::to_real<R>(factor(p)) * numeric::cos_pi_alpha<R>(p.coupled_friction(0)) / numeric::pi<R>();
    return power_form<R>({-1, 1}, {-(half + alpha(p, 0)), -(half - alpha(p, 0))}, {size});
  });
}

template <Real R>
std::vector<Evidence> walk(const Context& context, const PunchFormula& formula, bool unit_load) {
  const Cases cases = punch_cases(context, "eq-04", grid(), count_for(context, 30, 10, 4), [](Random&) { return 0; });
  Findings findings;
  for (const ContactProblem& problem : cases.problems) {
    findings.begin_case(text_of(problem), problem.coupled_friction(0) != 0);
    const PowerForm<R> form = formula.at<R>(problem);
    const auto no_slope = [](const auto& x) { return std::remove_cvref_t<decltype(x)>(0); };
    Surface<R> surface = surface_of<R>(form, problem, 0, no_slope);
    if (unit_load) surface.integral = 1;
    check_surface(findings, surface, count_for(context, 9, 3, 3));
    Surface<double> in_double = surface_of<double>(formula.at<double>(problem), problem, 0, no_slope);
    if (unit_load) in_double.integral = 1;
    check_surface_by_gsl(findings, in_double);
    if (!unit_load) check_punch_values(findings, form, problem);
    findings.decide("alpha = arctan(s)/pi lies in [0, 1/2[",
                    alpha(problem, 0).sign() >= 0 && (half - alpha(problem, 0)).sign() > 0);
  }
  return findings.evidence(cases.detail);
}

auto check(bool unit_load) {
  return [unit_load](const Context& context, const PunchFormula& formula) {
    return gather([&] {
      return numeric::at_precision(context.digits, [&]<Real R>() { return walk<R>(context, formula, unit_load); });
    });
  };
}

std::vector<Wrong<PunchFormula>> wrong_variants(const PunchFormula& right) {
  return {
      {"the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha}",
       right.changed([](auto& form, const ContactProblem&) { form.set_exponent(0, -half); })},
      {"the power -(1/2-alpha) at the rear edge",
       right.changed([](auto& form, const ContactProblem& p) { form.set_exponent(0, -(half - alpha(p, 0))); })},
      {"the powers of both edges exchanged", right.changed([](auto& form, const ContactProblem& p) {
         form.set_exponent(0, -(half - alpha(p, 0)));
         form.set_exponent(1, -(half + alpha(p, 0)));
       })},
      {"cos(pi alpha) missing", right.changed([]<Real R>(PowerForm<R>& form, const ContactProblem& p) {
         form.scale(1 / numeric::cos_pi_alpha<R>(p.coupled_friction(0)));
       })},
      {"1/pi missing",
       right.changed([]<Real R>(PowerForm<R>& form, const ContactProblem&) { form.scale(numeric::pi<R>()); })},
      {"alpha = arctan(f)/pi, gamma missing", right.changed([](auto& form, const ContactProblem& p) {
         const Exponent angle = Exponent::angle(p.friction().values()[0]);
         form.set_exponent(0, -(half + angle));
         form.set_exponent(1, -(half - angle));
       })},
      {"near miss: the rear exponent moved by ten times the tolerance",
       right.changed([]<Real R>(PowerForm<R>& form, const ContactProblem&) { form.move_power(0, near_miss<R>()); })},
      {"near miss: alpha moved by ten times the tolerance, the exponents' sum kept",
       right.changed([]<Real R>(PowerForm<R>& form, const ContactProblem&) {
         form.move_power(0, R(-near_miss<R>()));
         form.move_power(1, near_miss<R>());
       })},
      {"near miss: the amplitude moved by ten times the tolerance",
       right.changed([]<Real R>(PowerForm<R>& form, const ContactProblem&) { form.scale(1 + near_miss<R>()); })}};
}

}  // namespace

std::vector<Claim> flat_punch_claims() {
  const PunchFormula traction = on_the_whole_punch([](const ContactProblem& p) { return Rational(-p.load()); });
  const PunchFormula unit = on_the_whole_punch([](const ContactProblem&) { return Rational(1); });
  return {
      make_claim(
          {"eq-04-flat-punch", "[Bal16, (4)]: flat punch, constant friction",
           "The flat punch under constant friction has the traction `t = -(P cos(pi alpha)/pi) (1+x)^{-(1/2+alpha)} "
           "(1-x)^{-(1/2-alpha)}`, `alpha = arctan(gamma f)/pi`: it satisfies `A t = 0` on `]-1, 1[` and carries the "
           "load `P`.",
           "Plane strain, rigid flat punch on `]-1, 1[` moving towards `+x`, `-1 < nu < 1/2`, `f >= 0` constant, `P > "
           "0`; examined for `f` from 0 to 50.",
           "`Y(z) = (z+1)^{-(1/2+alpha)} (z-1)^{-(1/2-alpha)}` has `Y^+ = -exp(2 pi i alpha) Y^-` on `]-1, 1[` and "
           "behaves as `1/z` at infinity. With `Phi = P Y/(2 pi i)` the equation `A t = 0`, which is `(s+i) Phi^+ = "
           "(s-i) Phi^-`, holds for `t = Phi^+ - Phi^- = -(P/pi) cos(pi alpha) |Y|`, and the coefficient of `1/z` in "
           "`Phi` makes `int t = -P`. Here `A t` and `int t` are computed by quadratures that know nothing of this."},
          check(false), traction, wrong_variants(traction)),
      make_claim(
          {"eq-08-unit-solution", "[Bal16, (8)]: the function t_0 of section 3",
           "`t_0 = (cos(pi alpha)/pi) (1+x)^{-(1/2+alpha)} (1-x)^{-(1/2-alpha)}` has `A t_0 = 0` on `]-1, 1[` and `int "
           "t_0 = 1`.",
           "`s = gamma f >= 0` constant, `alpha = arctan(s)/pi`; examined for `-1 < nu < 1/2` and `f` from 0 to 50.",
           "`t_0` is the traction of the flat punch under the load -1: the jump of `-Y/(2 pi i)` with `Y(z) = "
           "(z+1)^{-(1/2+alpha)} (z-1)^{-(1/2-alpha)}`, which behaves as `1/z` at infinity. It spans the kernel of `A` "
           "among integrable tractions: any other solution of `A t = 0` would be `Y` times a function without poles "
           "that is bounded at infinity, a constant."},
          check(true), unit, wrong_variants(unit))};
}

}  // namespace steadyslide::proofs_checks
