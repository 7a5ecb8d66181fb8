#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::n_jump_punch {
namespace {

/// Returns punches with 0, 1, ..., 8 friction jumps, sliding towards +x and -x, with Poisson's ratios and friction in
/// their whole ranges. The order has two reasons: controls begin with two jumps, and a quick run, which takes every
/// fourth or sixteenth case, gets cheap ones.
CaseList<ContactProblem> punches(const Context& context) {
  const std::vector<Rational> friction{Rational(1, 5), 2,  Rational(1, 2), 0, 50, 1,
                                       Rational(7, 3), 10, Rational(1, 10)};
  const std::vector<Rational> nus{Rational(3, 10), Rational(-9, 10), 0, Rational(499, 1000), Rational(2, 5)};
  std::vector<ContactProblem> grid;
  for (const std::size_t m : {2U, 0U, 5U, 6U, 1U, 4U, 7U, 8U, 3U}) {
    std::vector<Rational> f(friction.begin(), friction.begin() + static_cast<std::ptrdiff_t>(m) + 1);
    std::vector<Rational> jumps;
    for (std::size_t k = 1; k <= m; ++k) {
      const auto position = static_cast<long>(k);
      jumps.push_back(Rational(-1) + Rational(2 * position, static_cast<long>(m) + 1) + Rational(position % 3, 50));
    }
    grid.push_back(punch(nus[m % nus.size()], std::move(f), std::move(jumps), Rational(5, 7),
                         m % 3 == 0 ? Sliding::minus_x : Sliding::plus_x));
  }
  return grid_and_random(context, "n-jump-punch", grid, {20, 6, 2}, [&](Random& random) {
    return random_punch(context, random, 1 + random.below(count_for(context, {8, 4, 3})));
  });
}

}  // namespace

Claim claim() {
  return formula_claim<ContactProblem, PowerProduct>("n-jump-punch")
      .cases(punches)
      .effective_where(has_jump)
      .says(punch_traction)
      .checked([]<Real R>(Findings& findings, const PowerProduct& t, const ContactProblem& p, const Context& context) {
        check_punch_traction<R>(findings, t, p, count_for(context, {10, 3, 2}));
      })
      .wrong("the exponent of one jump missing", [](PowerProduct& t) { t.exponents[1] = Exponent(0); })
      .wrong("the exponents of two jumps exchanged",
             [](PowerProduct& t) {
               if (t.exponents.size() >= 4) std::swap(t.exponents[1], t.exponents[2]);
             })
      .wrong("a jump shifted by 1/50",
             [](PowerProduct& t) {
               if (t.lengths.size() < 2) return;
               const Number shift = t.lengths[0] / 50;
               t.lengths[0] += shift;
               t.lengths[1] -= shift;
             })
      .wrong("the friction read from the front to the rear",
             [](PowerProduct& t, const ContactProblem& p) {
               std::vector<Exponent> alpha = angles(p);
               std::ranges::reverse(alpha);
               t.exponents = punch_powers(alpha);
               std::ranges::reverse(t.amplitudes);
             })
      .wrong("one amplitude on all panels",
             [](PowerProduct& t) { std::ranges::fill(t.amplitudes, Number(t.amplitudes[0])); })
      .wrong("the other direction of sliding: `alpha` of the other sign",
             [](PowerProduct& t, const ContactProblem& p) {
               std::vector<Exponent> alpha = angles(p);
               for (Exponent& angle : alpha) angle = -angle;
               t.exponents = punch_powers(alpha);
             })
      .near_miss("one jump's exponent", [](PowerProduct& t, const Number& step) { t.move_power(1, step); })
      .near_miss("the amplitude", [](PowerProduct& t, const Number& step) { t.scale(1 + step); });
}

}  // namespace steadyslide::proofs_checks::n_jump_punch
