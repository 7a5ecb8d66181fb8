#include "app/figures/two_coatings.hpp"

#include <algorithm>
#include <cmath>

#include "app/figures/solved.hpp"

namespace steadyslide::app {
namespace {

const Rational low(1, 10);
const Rational high(1);

std::string friction_text(const Rational& f) { return "{/:Italic f} = " + to_string(f); }

/// With points so near the jump that the curve leaves the frame, or reaches the axis.
std::vector<Point> with_jump(const numeric::ContactSolution<double>& solution) {
  std::vector<Point> curve = pressure_curve(solution, 401);
  for (int k = 4; k <= 60; ++k) {
    for (const double x : {-std::pow(0.5, k), std::pow(0.5, k)}) {
      curve.push_back({x, -solution.at(Rational(x)).traction.left.value});
    }
  }
  std::ranges::sort(curve, {}, &Point::x);
  return curve;
}

Panel two_coatings(Sliding sliding) {
  Panel panel = empty_panel({0.085, 0.98, 0.165, 0.91}, {"{/:Italic x} / {/:Italic L}", -1.05, 1.05, false, 0.5},
                            {"pressure −{/:Italic t}_n  ({/:Italic P}/{/:Italic L})", 0, 1.4, false, 0.2});
  const ContactProblem problem = flat_punch(Rational(1, 5), {low, high}, {0}, sliding);
  const ContactProblem uniform = flat_punch(Rational(1, 5), {(low + high) / 2}, {}, sliding);
  panel.series = {
      {"two coatings", Look::line, 1, with_jump(*solved(problem))},
      {"the same, on 800 cells", Look::marks, 1, pressure_of_cells(*solved_on_cells(problem, 800), 40)},
      {"one coating, " + friction_text((low + high) / 2), Look::line, 2, pressure_curve(*solved(uniform), 401)}};
  panel.legend = LegendAt::right_of_centre;
  const bool forward = sliding == Sliding::plus_x;
  panel.notes = {{{-0.5, 0.09, false, true}, friction_text(low), Align::centre},
                 {{0.5, 0.09, false, true}, friction_text(high), Align::centre},
                 {{0.05, 0.09, true, true}, forward ? "rear" : "front"},
                 {{0.95, 0.09, true, true}, forward ? "front" : "rear", Align::right},
                 {{0.25, 0.66, true, true}, "sliding", Align::centre}};
  const Place left{0.18, 0.61, true, true};
  const Place right{0.32, 0.61, true, true};
  panel.guides = {forward ? Guide{left, right, true} : Guide{right, left, true}};
  return panel;
}

const std::string caption =
    "Normal traction under a rigid flat punch with two coatings, `f = 0.1` on the left half and `f = 1` on the right "
    "half, `nu = 1/5`; the line by the closed form, marks by the solver on cells, and for comparison the same punch "
    "with the mean coefficient everywhere. ";

}  // namespace

Figure two_coatings_figure(std::string name, std::string title, const std::string& what_it_shows, Sliding sliding) {
  return {std::move(name), std::move(title), caption + what_it_shows, 435, {two_coatings(sliding)}};
}

}  // namespace steadyslide::app
