#include "numeric/flat_punch/flat_punch.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/instruments/tractions/punch_loads.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::flat_punch_centre_of_pressure {
namespace {

CaseList<ContactProblem> punches(const Context& context) {
  const Rational nu(1, 5);
  const std::vector<ContactProblem> grid{punch(nu, {Rational(1, 10), Rational(1, 2)}, {Rational(1, 5)}), punch(nu, {2}),
                                         punch(nu, {5, 0, 1}, {Rational(-9, 10), Rational(1, 3)}, 1, Sliding::minus_x),
                                         punch(nu, {1, 20, 0, 4}, {Rational(-1, 2), 0, Rational(1, 2)})};
  return grid_and_random(context, "flat-punch-centre-of-pressure", grid, {20, 6, 2}, [&](Random& random) {
    return random_punch(context, random, random.below(count_for(context, {7, 4, 3})));
  });
}

}  // namespace

Claim claim() {
  return compared<ContactProblem>("flat-punch-centre-of-pressure")
      .cases(punches)
      .effective_where(has_friction)
      .measured(one_value("centre", []<Real R>(const ContactProblem& p) { return punch_loads<R>(p).centre; }))
      .predicted(one_value(
          "centre", []<Real R>(const ContactProblem& p) { return R(-numeric::FrictionLayout<R>::of(p).moment(0)); }))
      .wrong("towards the front", scaled({"centre"}, -1))
      .wrong("the mean of `alpha`", scaled({"centre"}, 0.5))
      .wrong("the middle", replaced({{"centre", Number(0)}}))
      .wrong("without the friction of the first strip",
             [](Values& p, const ContactProblem& c) {
               const auto first = c.pieces().front();
               p["centre"] += to_real<Number>(alpha(c, 0)) * to_real<Number>(first.right - first.left);
             })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::flat_punch_centre_of_pressure
