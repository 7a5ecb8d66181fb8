// The effective friction of a flat punch with two coatings: tangential over normal force, for both directions.

#include "app/figures/solved.hpp"
#include "app/gnuplot/figure.hpp"

namespace steadyslide::app {
namespace {

const Rational nu(1, 5);

/// Draws marks at every tenth place.
std::vector<Series> curves(const std::function<Rational(const Rational& t)>& place,
                           const std::function<ContactProblem(const Rational& place, Sliding sliding)>& punch) {
  FrictionCurves wanted{{"right coating in front", "right coating at the rear"}, {}, punch, 9, 10};
  for (int i = 1; i < 100; ++i) wanted.places.push_back(place(Rational(i, 100)));
  return friction_curves(wanted);
}

}  // namespace

Figure make_effective_friction() {
  const Rational low(1, 10);
  const Rational high(1);
  const Axis friction{"effective friction {/:Italic T}/{/:Italic P}", 0, 1.05, false, 0.2};

  // The points are denser towards the ends, because there the curve changes like a square root.
  const auto smooth = [](const Rational& t) { return Rational(t * t * (3 - 2 * t)); };
  const auto place = [&](const Rational& t) { return Rational(2 * smooth(smooth(t)) - 1); };
  const auto moved = [&](const Rational& c, Sliding sliding) { return flat_punch(nu, {low, high}, {c}, sliding); };
  Panel by_place{
      {0.085, 0.49, 0.175, 0.9}, {"place of the jump {/:Italic c} / {/:Italic L}", -1, 1, false, 0.5}, friction};
  by_place.legend = LegendAt::none;
  by_place.series = curves(place, moved);
  const auto low_value = numeric::to_real<double>(low);
  by_place.series.push_back({"plain mean", Look::line, 3, {{-1, numeric::to_real<double>(high)}, {1, low_value}}});
  by_place.notes = {{{0.04, 0.06, true, true}, "{/:Italic f} = 0.1 on the left, 1 on the right"}};

  const auto value = [](const Rational& t) { return Rational(3 * t); };
  const auto rougher = [&](const Rational& f, Sliding sliding) { return flat_punch(nu, {low, f}, {0}, sliding); };
  Panel by_value{{0.585, 0.985, 0.175, 0.9},
                 {"friction of the right coating {/:Italic f}", 0, 3, false, 0.5},
                 {"effective friction {/:Italic T}/{/:Italic P}", 0, 2, false, 0.5}};
  by_value.legend = LegendAt::top_left;
  by_value.series = curves(value, rougher);
  by_value.series.push_back({"plain mean", Look::line, 3, {{0, low_value / 2}, {3, (low_value + 3) / 2}}});
  by_value.notes = {{{0.96, 0.06, true, true}, "{/:Italic f} = 0.1 on the left half", Align::right}};
  return {
      "effective-friction",
      "Effective friction of a punch with two coatings",
      "Tangential over normal force, `T/P`, of a flat punch with two coatings, `nu = 1/5`, for both directions of "
      "sliding: against the place of the friction jump (left, `f = 0.1` and 1), and against the right coating's "
      "friction with the jump in the middle (right, `f = 0.1` on the left half). Lines by the closed form, marks by "
      "the solver on 1000 cells. The plain mean weighs the coefficients by length; the pressure does not.",
      430,
      {by_place, by_value}};
}

}  // namespace steadyslide::app
