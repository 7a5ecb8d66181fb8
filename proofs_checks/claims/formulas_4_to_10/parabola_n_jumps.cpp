#include "numeric/closed_form/closed_form.hpp"
#include "proofs_checks/instruments/tractions/parabola_cases.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::parabola_n_jumps {
namespace {

CaseList<ContactProblem> parabolas(const Context& context) {
  const std::vector<ContactProblem> grid{
      parabola(Rational(3, 10), {Rational(1, 2), 3, 1}, {Rational(-1, 5), Rational(1, 10)}, 1, 1),
      parabola(Rational(3, 10), {Rational(1, 2), 2}, {0}, Rational(1, 5), 1),
      parabola(Rational(3, 10), {2, Rational(1, 2)}, {0}, Rational(1, 5), 1, Rational(1, 3), Sliding::minus_x),
      // The outer jumps lie outside of the contact.
      parabola(0, {1, 0, 2, Rational(1, 3)}, {-5, Rational(1, 20), 7}, Rational(1, 2), 1),
      parabola(Rational(-9, 10), {50, 1, 10}, {Rational(-3, 5), Rational(1, 7)}, 2, 2),
      parabola(Rational(499, 1000), {1, 50}, {Rational(-1, 9)}, 1, 3)};
  return grid_and_random(context, "parabola-jumps", grid, {30, 6, 3}, [&](Random& random) {
    const std::size_t m = 1 + random.below(4);
    std::vector<Rational> friction;
    for (std::size_t piece = 0; piece <= m; ++piece) friction.push_back(random.friction(largest_friction(context)));
    const Rational load = random.between(0, 4);
    const Rational radius = random.between(0, 4);
    const std::vector<Rational> jumps = random_jumps(random, m);
    return parabola(random.poisson(), friction, jumps, radius, load);
  });
}

/// Returns the claim's formula for the traction on the contact that the numeric layer finds.
ParabolaTraction traction_on_solved_zone(const ContactProblem& p) {
  const auto data = std::get<numeric::ClosedFormData<Number>>(numeric::closed_form_data<Number>(p));
  ParabolaTraction t;
  t.first_piece = data.first_piece;
  t.left_end = data.traction.weight.point(0);
  std::vector<Exponent> angles;
  const auto radius = to_real<Number>(radius_of(p));
  for (std::size_t k = 0; k < data.traction.weight.panel_count(); ++k) {
    t.lengths.push_back(data.traction.weight.panel(k).length);
    t.amplitudes.push_back(-cos_pi_alpha<Number>(s_of(p, data.first_piece + k)) / radius);
    angles.push_back(alpha(p, data.first_piece + k));
  }
  // The power of a free end is that of an edge plus one.
  t.exponents = punch_powers(angles);
  t.exponents.front() += Exponent(1);
  t.exponents.back() += Exponent(1);
  return t;
}

bool jumps_inside(const ContactProblem& p) {
  const std::vector<Exponent> exponents = traction_on_solved_zone(p).exponents;
  return std::ranges::any_of(exponents.begin() + 1, exponents.end() - 1,
                             [](const Exponent& e) { return e.sign() != 0; });
}

void move_rear_end(ParabolaTraction& t, const Number& by) {
  t.left_end -= by;
  t.lengths[0] += by;
}

}  // namespace

Claim claim() {
  return formula_claim<ContactProblem, ParabolaTraction>("parabola-n-jumps")
      .cases(parabolas)
      .effective_where(jumps_inside)
      .says(traction_on_solved_zone)
      .checked(
          []<Real R>(Findings& findings, const ParabolaTraction& t, const ContactProblem& p, const Context& context) {
            check_parabola<R>(findings, t, p, context);
            check_parabola_by_cln<R>(findings, t, p);
          })
      .wrong("the zone shifted to the front", [](ParabolaTraction& t) { t.left_end += t.lengths[0] / 20; })
      .wrong("the exponent of one jump missing", [](ParabolaTraction& t) { t.exponents[1] = Exponent(0); })
      .wrong("every jump's exponent with the other sign",
             [](ParabolaTraction& t) {
               for (std::size_t j = 1; j + 1 < t.exponents.size(); ++j) t.exponents[j] = -t.exponents[j];
             })
      .wrong("the powers of both free ends exchanged",
             [](ParabolaTraction& t) { std::swap(t.exponents.front(), t.exponents.back()); })
      .wrong("one amplitude on all panels",
             [](ParabolaTraction& t) { std::ranges::fill(t.amplitudes, Number(t.amplitudes[0])); })
      .wrong("the rear end moved outwards by a hundredth of its panel",
             [](ParabolaTraction& t) { move_rear_end(t, t.lengths[0] / 100); })
      .near_miss("the rear end", [](ParabolaTraction& t, const Number& step,
                                    const ContactProblem&) { move_rear_end(t, t.lengths[0] * step); })
      .near_miss("one jump's exponent", [](ParabolaTraction& t, const Number& step) { t.move_power(1, step); })
      .near_miss("the amplitude", [](ParabolaTraction& t, const Number& step) { t.scale(1 + step); });
}

}  // namespace steadyslide::proofs_checks::parabola_n_jumps
