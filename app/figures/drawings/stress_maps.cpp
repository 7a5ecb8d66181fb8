// Von Mises' stress in the body under a flat punch with two coatings, and under a parabola.

#include <algorithm>
#include <cmath>

#include "app/figures/solved.hpp"
#include "app/figures/stress_map.hpp"

namespace steadyslide::app {
namespace {

/// The height of arrows and notes above the surface, as a fraction of the panel.
constexpr double note_height = 1.035;

void add_direction(Panel& panel, double from, double to) {
  panel.notes.push_back({{from - 0.03, note_height, false, true}, "sliding", Align::right});
  panel.guides.push_back({{from, note_height, false, true}, {to, note_height, false, true}, true});
}

}  // namespace

ContactProblem stress_map_problem() { return flat_punch(Rational(1, 5), {Rational(1, 10), 1}, {0}); }

ContactProblem stress_parabola_problem() { return parabola(Rational(3, 10), {Rational(1, 5)}, Rational(1, 50)); }

Figure make_stress_map() {
  const ContactProblem problem = stress_map_problem();
  const auto solution = solved_by_singular_functions(problem);
  const MapView view{.width = 2,
                     .depth = 2,
                     .highest = 1.2,
                     .length_name = "{/:Italic L}",
                     .stress_name = "{/:Italic P}/{/:Italic L}",
                     .contours = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8}};
  Panel panel = stress_panel(*solution, problem, view);
  const numeric::LargestStress<double> largest =
      mark_largest(panel, *solution, view, numeric::default_depth(*solution));
  panel.notes.insert(panel.notes.end(), {{{-0.5, note_height, false, true}, "{/:Italic f} = 0.1", Align::centre},
                                         {{0.5, note_height, false, true}, "{/:Italic f} = 1", Align::centre}});
  for (const double x : {-1.0, 0.0, 1.0}) panel.guides.push_back({{x, 1, false, true}, {x, 1.06, false, true}});
  add_direction(panel, 1.55, 1.9);
  // Rounded up.
  const double error = std::ceil(1e4 * surface_error(*solution, problem, Rational(1, 1000))) / 1e4;
  return {
      "stress-map",
      "Stress below a flat punch with two coatings",
      "Von Mises' stress in units of `P/L` (white 0, black " + decimal(view.highest, 1) +
          " and more) below a flat punch on `]-1, 1[` that slides to the right, `f = 0.1` on its left half and 1 on "
          "its right one, `nu = 1/5`. It has no bound next to the edges and the jump; the cross is where it is largest "
          "at depths of `0.02 L` and more: " +
          decimal(largest.von_mises.value, 4) + " at `x` = " + decimal(largest.x.value, 4) +
          " `L`, `z` = " + decimal(largest.z.value, 4) +
          " `L`. The row at the surface is made from the tractions and from the slope of the tangential displacement. "
          "At the depth `z = 0.001 L`, at a distance of 0.25 from the singular points, `sigma_{zz}` and `sigma_{xz}` "
          "differ from `t_n` and `-t_t` by at most " +
          decimal(error, 4) + " in these units.",
      450,
      {panel}};
}

Figure make_stress_parabola() {
  const ContactProblem problem = stress_parabola_problem();
  const auto solution = solved(problem);
  const auto zone = solution->contact().front();
  const double a = zone.width.value / 2;
  const MapView view{.length = a,
                     .stress = numeric::to_real<double>(problem.load()) / a,
                     .width = 2,
                     .depth = 2,
                     .highest = 0.45,
                     .length_name = "{/:Italic a}",
                     .stress_name = "{/:Italic P}/{/:Italic a}",
                     .contours = {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35}};
  Panel panel = stress_panel(*solution, problem, view);
  const numeric::LargestStress<double> largest = mark_largest(panel, *solution, view, 0);
  for (const auto& end : {zone.left, zone.right}) {
    panel.guides.push_back({{end.x.value / a, 1, false, true}, {end.x.value / a, 1.06, false, true}});
  }
  panel.notes.push_back({{-0.05, note_height, false, true}, "contact", Align::centre});
  add_direction(panel, 1.55, 1.9);
  return {
      "stress-parabola",
      "Stress below a parabola",
      "Von Mises' stress in units of `P/a` (white 0, black " + decimal(view.highest, 2) +
          " and more) below a rigid parabola that slides to the right, `f = 1/5`, `nu = 3/10`; `a` is the half-length "
          "of the contact. The cross is where it is largest: " +
          decimal(largest.von_mises.value / view.stress, 4) + " at `x` = " + decimal(largest.x.value / a, 4) +
          " `a`, `z` = " + decimal(largest.z.value / a, 4) +
          " `a`: below the surface, as without friction, and in the front half.",
      450,
      {panel}};
}

}  // namespace steadyslide::app
