#include "proofs_checks/instruments/tractions/constant_punch.hpp"

#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {
namespace {

CaseList<ContactProblem> punches(const Context& context) {
  std::vector<ContactProblem> grid;
  for (const Rational& nu : {Rational(3, 10), Rational(-9, 10), Rational(0), Rational(499, 1000)}) {
    for (const Rational& f : {Rational(1), Rational(1, 5), Rational(10), Rational(50), Rational(0)}) {
      grid.push_back(punch(nu, {f}, {}, Rational(7, 3)));
    }
  }
  return grid_and_random(context, "eq-04", grid, {30, 10, 4},
                         [&](Random& random) { return random_punch(context, random, 0); });
}

}  // namespace

Claim constant_punch_claim(std::string id, PunchLoad load) {
  return formula_claim<ContactProblem, PowerProduct>(std::move(id))
      .cases(punches)
      .effective_where(has_friction)
      .says([load](const ContactProblem& p) {
        if (load == PunchLoad::given) return punch_traction(p);
        PowerProduct t = punch_traction(p.with_load(1));
        t.scale(-1);
        return t;
      })
      .checked(
          [load]<Real R>(Findings& findings, const PowerProduct& t, const ContactProblem& p, const Context& context) {
            Surface<R> surface = surface_of<R>(t.at<R>(), p, 0);
            Surface<double> in_double = surface_of<double>(t.at<double>(), p, 0);
            if (load == PunchLoad::minus_one) surface.integral = in_double.integral = 1;
            check_surface(findings, surface, count_for(context, {9, 3, 3}));
            check_surface_by_gsl(findings, in_double);
            if (load == PunchLoad::given) check_punch_values(findings, t.at<R>(), p);
            findings.decide("`alpha = arctan(s)/pi` lies in [0, 1/2[",
                            alpha(p, 0).sign() >= 0 && (half - alpha(p, 0)).sign() > 0);
          })
      .wrong("the printed `(1+x)^{1/2}` instead of `(1+x)^{1/2+alpha}`",
             [](PowerProduct& t) { t.exponents[0] = -half; })
      .wrong("the power `-(1/2-alpha)` at the rear edge",
             [](PowerProduct& t, const ContactProblem& p) { t.exponents[0] = -(half - alpha(p, 0)); })
      .wrong("the powers of both edges exchanged", [](PowerProduct& t) { std::swap(t.exponents[0], t.exponents[1]); })
      .wrong("`cos(pi alpha)` missing",
             [](PowerProduct& t, const ContactProblem& p) { t.scale(1 / cos_pi_alpha<Number>(p.coupled_friction(0))); })
      .wrong("`1/pi` missing", [](PowerProduct& t) { t.scale(numeric::pi<Number>()); })
      .wrong("`alpha = arctan(f)/pi`, `gamma` missing",
             [](PowerProduct& t, const ContactProblem& p) {
               t.exponents = punch_powers({Exponent::angle(p.friction().values()[0])});
             })
      .near_miss("the rear exponent", [](PowerProduct& t, const Number& step) { t.move_power(0, step); })
      .near_miss("`alpha`, the exponents' sum kept,",
                 [](PowerProduct& t, const Number& step) {
                   t.move_power(0, -step);
                   t.move_power(1, step);
                 })
      .near_miss("the amplitude", [](PowerProduct& t, const Number& step) { t.scale(1 + step); });
}

}  // namespace steadyslide::proofs_checks
