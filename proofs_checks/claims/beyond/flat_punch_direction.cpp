#include "numeric/flat_punch/flat_punch.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/instruments/tractions/punch_loads.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::flat_punch_direction {
namespace {

CaseList<ContactProblem> punches(const Context& context) {
  const Rational nu(1, 5);
  const std::vector<ContactProblem> grid{
      punch(nu, {Rational(1, 10), Rational(1, 2)}, {0}),
      punch(nu, {5, 0, 1}, {Rational(-9, 10), Rational(1, 3)}),
      punch(nu, {2, 3, 0, Rational(1, 2)}, {Rational(-1, 4), Rational(1, 8), Rational(4, 5)}),
      punch(nu, {Rational(1, 100), 0}, {Rational(1, 7)}),
  };
  return grid_and_random(context, "flat-punch-direction", grid, {20, 3, 1}, [&](Random& random) {
    return random_punch(context, random, 1 + random.below(count_for(context, {6, 3, 2})));
  });
}

}  // namespace

Claim claim() {
  return compared<ContactProblem>("flat-punch-direction")
      .cases(punches)
      .effective_where(has_jump)
      .measured([]<Real R>(const ContactProblem& p) {
        const R forth = punch_loads<R>(p.with_sliding(Sliding::plus_x)).friction;
        const R back = punch_loads<R>(p.with_sliding(Sliding::minus_x)).friction;
        return Values{{"difference", R((forth - back) / (forth + back))}};
      })
      .predicted([]<Real R>(const ContactProblem& p) {
        const numeric::EffectiveFriction<R> friction(numeric::FrictionLayout<R>::of(p));
        const R difference = friction.direction_difference().value;
        return Values{{"difference", R(difference / (2 * friction.value().value - difference))}};
      })
      .wrong("no difference", replaced({{"difference", Number(0)}}))
      .wrong("`A` and `B` exchanged", scaled({"difference"}, -1))
      .wrong("`1/pi` for `2/pi`", scaled({"difference"}, 0.5))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::flat_punch_direction
