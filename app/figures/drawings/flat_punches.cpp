// Pressure under a flat punch with one friction coefficient, and with two coatings, the smoother one on the left, for
// both directions of sliding. [Bal16, (4)-(7), figures 3 and 4]

#include <algorithm>
#include <cmath>

#include "app/figures/solved.hpp"
#include "app/gnuplot/figure.hpp"

namespace steadyslide::app {
namespace {

const Rational low(1, 10);
const Rational high(1);

std::string friction_text(const Rational& f) { return "{/:Italic f} = " + to_string(f); }

Panel pressure_panel() {
  return {{0.085, 0.98, 0.165, 0.91},
          {"{/:Italic x} / {/:Italic L}", -1.05, 1.05, false, 0.5},
          {"pressure −{/:Italic t}_n  ({/:Italic P}/{/:Italic L})", 0, 1.4, false, 0.2}};
}

/// Adds points so near the jump that the curve leaves the frame, or reaches the axis.
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
  Panel panel = pressure_panel();
  const ContactProblem problem = flat_punch(Rational(1, 5), {low, high}, {0}, sliding);
  const ContactProblem uniform = flat_punch(Rational(1, 5), {(low + high) / 2}, {}, sliding);
  panel.series = {
      {"two coatings", Look::line, 1, with_jump(*solved(problem))},
      {"the same, on 800 cells", Look::marks, 1, pressure_of_cells(*solved_on_cells(problem, 800), 40)},
      {"one coating, " + friction_text((low + high) / 2), Look::line, 2, pressure_curve(*solved(uniform), 401)}};
  panel.legend = LegendAt::right_of_centre;
  const bool forward = sliding == Sliding::plus_x;
  const auto points = solved(problem)->singular_points();
  panel.notes = {{{-0.5, 0.09, false, true}, friction_text(low), Align::centre},
                 {{0.5, 0.09, false, true}, friction_text(high), Align::centre},
                 {{0.05, 0.09, true, true}, forward ? "rear" : "front"},
                 {{0.95, 0.09, true, true}, forward ? "front" : "rear", Align::right},
                 {{0.25, 0.66, true, true}, "sliding", Align::centre},
                 {{0.09, 0.93, true, true}, exponent_text("−½ − α_{−}", points[0])},
                 {forward ? PanelPosition{0.025, 0.9} : PanelPosition{0.04, 0.06}, exponent_text("β", points[1])},
                 {{0.89, 0.53, true, true}, exponent_text("−½ + α_{+}", points[2]), Align::right}};
  const PanelPosition left{0.18, 0.61, true, true};
  const PanelPosition right{0.32, 0.61, true, true};
  panel.guides = {forward ? Guide{left, right, true} : Guide{right, left, true}};
  return panel;
}

const std::string two_coatings_caption =
    "Normal traction under a rigid flat punch with two coatings, `f = 0.1` on the left half and `f = 1` on the right "
    "half, `nu = 1/5`; the line by the closed form, marks by the solver on cells, and for comparison the same punch "
    "with the mean coefficient everywhere. ";

}  // namespace

Figure make_flat_punch() {
  Panel panel = pressure_panel();
  int style = 0;
  std::vector<std::string> rear, front;
  for (const Rational& f : {Rational(0), Rational(3, 10), Rational(1)}) {
    const ContactProblem problem = flat_punch(Rational(1, 5), {f});
    const auto points = solved(problem)->singular_points();
    rear.push_back(exponent_text("−½ − α", points[0]));
    front.push_back(exponent_text("−½ + α", points[1]));
    panel.series.push_back({friction_text(f), Look::line, ++style, pressure_curve(*solved(problem), 401)});
    panel.series.push_back({"", Look::marks, style, pressure_of_cells(*solved_on_cells(problem, 800), 40)});
  }
  panel.legend = LegendAt::top_centre;
  panel.notes = {{{0.04, 0.07, true, true}, "rear"},
                 {{0.96, 0.07, true, true}, "front", Align::right},
                 {{0.5, 0.105, true, true}, "sliding", Align::centre}};
  for (std::size_t k = 0; k < rear.size(); ++k) {
    const double y = 0.93 - 0.075 * static_cast<double>(k);
    panel.notes.push_back({{0.1, y, true, true}, rear[k]});
    panel.notes.push_back({{0.9, y, true, true}, front[k], Align::right});
  }
  panel.guides = {{{0.42, 0.06, true, true}, {0.58, 0.06, true, true}, true}};
  return {
      "flat-punch",
      "Flat punch with one friction coefficient",
      "Normal traction under a rigid flat punch of half-width `L` that slides to the right under the load `P`, "
      "`nu = 1/5`: lines by the closed form `t_n = -P cos(pi alpha)/pi (1+x)^{-(1/2+alpha)} (1-x)^{-(1/2-alpha)}` "
      "(`L = 1`), marks by the solver on 800 cells, which knows no exponents. Those at the edges are written beside "
      "them, in the order of the legend. With friction the rear is loaded more than the front, and its singularity is "
      "the stronger one.",
      430,
      {panel}};
}

Figure make_friction_jump_rising() {
  return {"friction-jump-rising",
          "Two coatings, the rougher one in front",
          two_coatings_caption +
              "Sliding to the right, friction rises towards the front: `beta = alpha_- - alpha_+ < 0`, and the "
              "pressure is infinite like `|x|^beta` where it jumps.",
          435,
          {two_coatings(Sliding::plus_x)}};
}

Figure make_friction_jump_falling() {
  return {"friction-jump-falling",
          "Two coatings, the rougher one at the rear",
          two_coatings_caption +
              "The same punch sliding to the left: friction falls towards the front, and the pressure vanishes like "
              "`|x|^{-beta}` where it was infinite before, `beta < 0` being the exponent of the other way.",
          435,
          {two_coatings(Sliding::minus_x)}};
}

}  // namespace steadyslide::app
