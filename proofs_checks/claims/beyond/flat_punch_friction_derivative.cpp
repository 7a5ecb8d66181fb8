#include "numeric/flat_punch/flat_punch.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/instruments/tractions/punch_loads.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::flat_punch_friction_derivative {
namespace {

/// Returns the punches. The first jump is moved.
CaseList<ContactProblem> punches(const Context& context) {
  const Rational nu(1, 5);
  return first_when_quick<ContactProblem>(
      context,
      {punch(nu, {Rational(1, 10), Rational(1, 2)}, {Rational(1, 5)}),
       punch(nu, {5, 0, 1}, {Rational(-9, 10), Rational(1, 3)}), punch(nu, {2, 3}, {Rational(99, 100)}),
       punch(nu, {1, 20, 0, 4}, {Rational(-1, 2), 0, Rational(1, 2)}, 1, Sliding::minus_x)},
      1, "flat punches");
}

ContactProblem moved(const ContactProblem& p, const Rational& way) {
  std::vector<Rational> jumps = p.friction().jumps();
  jumps.front() += way;
  return p.with_friction(FrictionProfile(p.friction().values(), jumps));
}

/// Returns ds_eff/dc divided by the change of alpha at c, from the tractions.
template <Real R>
R measured(const ContactProblem& p) {
  const Rational step(1, 1'000'000'000'000);
  const R gamma = to_real<R>(p.with_friction(FrictionProfile({1})).coupled_friction(0));
  const R difference = gamma * (punch_loads<R>(moved(p, step)).friction - punch_loads<R>(moved(p, -step)).friction);
  return difference / (2 * to_real<R>(step)) / to_real<R>(alpha(p, 0) - alpha(p, 1));
}

template <Real R>
R weight(const ContactProblem& p, const Rational& place) {
  const numeric::EffectiveFriction<R> friction(numeric::FrictionLayout<R>::of(p));
  return friction.derivative(to_real<R>(1 + place), to_real<R>(1 - place)).value;
}

}  // namespace

Claim claim() {
  return compared<ContactProblem>("flat-punch-friction-derivative")
      .cases(punches)
      .precision(Precision::at_least_fifty)
      .measured([]<Real R>(const ContactProblem& p) {
        const R w = measured<R>(p);
        return Values{{"derivative", w}, {"it is positive", w > 0}};
      })
      .predicted([]<Real R>(const ContactProblem& p) {
        return Values{{"derivative", weight<R>(p, p.friction().jumps().front())}, {"it is positive", true}};
      })
      .wrong("`w` at the mirrored place",
             [](Values& p, const ContactProblem& c) {
               p["derivative"] = weight<Number>(c, Rational(-c.friction().jumps().front()));
             })
      .wrong("`w` of the friction on the left everywhere",
             [](Values& p, const ContactProblem& c) {
               const ContactProblem one = c.with_friction(FrictionProfile({c.friction().values().front()}));
               p["derivative"] = weight<Number>(one, c.friction().jumps().front());
             })
      .wrong("the derivative by `s` for that by `alpha`",
             [](Values& p, const ContactProblem& c) {
               const auto cosine = cos_pi_alpha<Number>(c.coupled_friction(0));
               p["derivative"] *= cosine * cosine / numeric::pi<Number>();
             })
      .wrong("more friction at a place is less friction", replaced({{"it is positive", false}}))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::flat_punch_friction_derivative
