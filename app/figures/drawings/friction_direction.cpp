// One punch, two coatings, two directions: two coefficients of friction.

#include <fmt/format.h>

#include "app/figures/solved.hpp"

namespace steadyslide::app {
namespace {

const Rational smooth_half(1, 10);
const Rational rough_half(1, 2);

ContactProblem punch(const Rational& jump, Sliding sliding) {
  return flat_punch(Rational(1, 5), {smooth_half, rough_half}, {jump}, sliding);
}

/// Draws a punch with its coatings and its direction of sliding; `at` is the middle of its lower face.
void add_punch(Panel& panel, const Point& at, Sliding sliding) {
  constexpr double half = 0.16, height = 0.05;
  panel.series.push_back(
      {"punch",
       Look::area,
       3,
       {{at.x - half, at.y}, {at.x + half, at.y}, {at.x + half, at.y + height}, {at.x - half, at.y + height}}});
  panel.series.push_back({"smooth half", Look::band, 7, {{at.x - half, at.y}, at}});
  panel.series.push_back({"rough half", Look::band, 2, {at, {at.x + half, at.y}}});
  const double direction = sliding == Sliding::plus_x ? 1 : -1, middle = at.y + height / 2;
  panel.guides.push_back({{at.x - 0.1 * direction, middle}, {at.x + 0.1 * direction, middle}, true});
}

}  // namespace

Figure make_friction_direction() {
  Panel panel{{0.085, 0.985, 0.155, 0.91},
              {"border {/:Italic c} / {/:Italic L} of the coatings", -1, 1, false, 0.5},
              {"effective friction {/:Italic T}/{/:Italic P}", 0, 0.56, false, 0.1}};
  panel.legend = LegendAt::none;
  FrictionCurves curves{{"to the right, rough coating in front", "to the left, smooth coating in front"}, {}, punch};
  // The points are denser towards the ends, because there the curve changes like a square root.
  for (int i = 1; i < 100; ++i) {
    const Rational t(i, 100);
    curves.places.emplace_back(2 * t * t * (3 - 2 * t) - 1);
  }
  panel.series = friction_curves(curves);
  for (const bool forward : {true, false}) {
    const double in_the_middle = effective_friction_of(punch(0, forward ? Sliding::plus_x : Sliding::minus_x));
    panel.series[forward ? 1 : 3].points = {{0, in_the_middle}};
    panel.notes.push_back({{forward ? -0.02 : 0.03, in_the_middle + (forward ? -0.03 : 0.03)},
                           decimal(in_the_middle, 3),
                           forward ? Align::right : Align::left,
                           16});
  }
  panel.guides = {{{0, 0, false, true}, {0, 1, false, true}}};
  add_punch(panel, {0.45, 0.4}, Sliding::minus_x);
  add_punch(panel, {-0.5, 0.16}, Sliding::plus_x);
  panel.notes.insert(panel.notes.end(), {{{0.45, 0.49}, "sliding left: rough coating at the rear", Align::centre, 16},
                                         {{-0.5, 0.12}, "sliding right: rough coating in front", Align::centre, 16},
                                         {{-0.66, 0.235}, "{/:Italic f} = 0.1", Align::centre},
                                         {{-0.34, 0.235}, "0.5", Align::centre}});
  Figure figure{
      "friction-direction",
      "One punch, two coatings: its friction depends on the direction of sliding",
      "Tangential over normal force of a flat punch `-L < x < L` with the friction coefficient 0.1 on the left of `c` "
      "and 0.5 on the right, `nu = 1/5`, sliding to the right and to the left, by the closed form; the marks are at "
      "`c = 0`, where each coating has a half.",
      420,
      {panel}};
  figure.digits = 5;  // a test compares the copy in docs/
  return figure;
}

}  // namespace steadyslide::app
