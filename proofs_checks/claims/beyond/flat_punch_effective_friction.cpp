#include "numeric/flat_punch/flat_punch.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/instruments/tractions/punch_loads.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::flat_punch_effective_friction {
namespace {

/// Returns punches with 1 to 6 friction jumps, for both directions of sliding.
CaseList<ContactProblem> punches(const Context& context) {
  const std::vector<Rational> friction{Rational(1, 10), Rational(1, 2), 5, 0, 2, Rational(1, 3), 1};
  const std::vector<Rational> nus{Rational(1, 5), 0, Rational(-1, 2), Rational(49, 100)};
  std::vector<ContactProblem> grid;
  for (const long m : {1, 3, 6, 2}) {
    std::vector<Rational> jumps;
    for (long k = 1; k <= m; ++k) jumps.push_back(Rational(-1) + Rational(2 * k, m + 1) + Rational(k % 3, 25));
    grid.push_back(punch(nus[static_cast<std::size_t>(m) % nus.size()], {friction.begin(), friction.begin() + m + 1},
                         std::move(jumps), 3, m % 3 == 0 ? Sliding::minus_x : Sliding::plus_x));
  }
  return grid_and_random(context, "flat-punch-effective-friction", grid, {20, 4, 1}, [&](Random& random) {
    return random_punch(context, random, 1 + random.below(count_for(context, {6, 4, 3})));
  });
}

/// Returns s/f.
Rational coupling(const ContactProblem& p) { return p.with_friction(FrictionProfile({1})).coupled_friction(0); }

template <Real R>
R by_surface(const ContactProblem& p) {
  return numeric::EffectiveFriction<R>(numeric::FrictionLayout<R>::of(p)).value().value / to_real<R>(coupling(p));
}

/// Returns the mean over the length of the punch of a quantity with one value on each strip.
template <class Value>
Number mean(const ContactProblem& p, const Value& value) {
  Number sum = 0;
  for (const auto& piece : p.pieces()) sum += to_real<Number>(piece.right - piece.left) / 2 * value(piece.friction);
  return sum;
}

Number mean_friction(const ContactProblem& p) {
  return mean(p, [&](std::size_t k) { return to_real<Number>(p.friction().values()[k]); });
}

Number of_mean_angle(const ContactProblem& p) {
  const Number angle = mean(p, [&](std::size_t k) { return to_real<Number>(alpha(p, k)); });
  return tan(Number(numeric::pi<Number>() * angle)) / to_real<Number>(coupling(p));
}

}  // namespace

Claim claim() {
  return compared<ContactProblem>("flat-punch-effective-friction")
      .cases(punches)
      .effective_where(has_jump)
      .measured(one_value("friction", []<Real R>(const ContactProblem& p) { return punch_loads<R>(p).friction; }))
      .predicted(one_value("friction", []<Real R>(const ContactProblem& p) { return by_surface<R>(p); }))
      .wrong("the mean of the coefficients",
             [](Values& p, const ContactProblem& c) { p["friction"] = mean_friction(c); })
      .wrong("`tan(pi <alpha>)/gamma`, as if the strips were ever finer",
             [](Values& p, const ContactProblem& c) { p["friction"] = of_mean_angle(c); })
      .wrong("`A` and `B` exchanged: the other direction of sliding",
             [](Values& p, const ContactProblem& c) {
               p["friction"] = by_surface<Number>(
                   c.with_sliding(c.sliding() == Sliding::plus_x ? Sliding::minus_x : Sliding::plus_x));
             })
      .wrong("without `1/pi`", scaled({"friction"}, numeric::pi<Number>()))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::flat_punch_effective_friction
