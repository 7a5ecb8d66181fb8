#include "numeric/flat_punch/flat_punch.hpp"

#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/instruments/tractions/punch_loads.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::flat_punch_rear_share {
namespace {

CaseList<ContactProblem> punches(const Context& context) {
  const Rational nu(1, 5);
  const std::vector<ContactProblem> grid{
      punch(nu, {Rational(1, 10), Rational(1, 2)}, {Rational(1, 5)}), punch(nu, {5, 0}, {Rational(-9, 10)}),
      punch(nu, {2, 3}, {Rational(3, 4)}, 1, Sliding::minus_x), punch(nu, {20, Rational(1, 3)}, {Rational(-1, 7)})};
  return grid_and_random(context, "flat-punch-rear-share", grid, {20, 6, 2},
                         [&](Random& random) { return random_punch(context, random, 1); });
}

/// Returns the load share behind the jump for s = `rear` behind it and s = `front` in front of it.
template <Real R>
R share(const ContactProblem& p, const Rational& rear, const Rational& front) {
  return numeric::rear_share<R>(rear, front, (p.friction().jumps().front() + 1) / 2).value;
}

}  // namespace

Claim claim() {
  return compared<ContactProblem>("flat-punch-rear-share")
      .cases(punches)
      .effective_where(has_jump)
      .measured(one_value("share", []<Real R>(const ContactProblem& p) { return punch_loads<R>(p).share.front(); }))
      .predicted(one_value(
          "share",
          []<Real R>(const ContactProblem& p) { return share<R>(p, p.coupled_friction(0), p.coupled_friction(1)); }))
      .wrong("both frictions exchanged",
             [](Values& p, const ContactProblem& c) {
               p["share"] = share<Number>(c, c.coupled_friction(1), c.coupled_friction(0));
             })
      .wrong("`alpha` of the other sign",
             [](Values& p, const ContactProblem& c) {
               p["share"] = share<Number>(c, -c.coupled_friction(0), -c.coupled_friction(1));
             })
      .wrong("the friction behind the jump under the whole punch",
             [](Values& p, const ContactProblem& c) {
               p["share"] = share<Number>(c, c.coupled_friction(0), c.coupled_friction(0));
             })
      .wrong("the share in front of the jump", [](Values& p) { p["share"] = 1 - p["share"]; })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::flat_punch_rear_share
