// Galin's parabola: profile and surface, and the pressure below. [Bal16, section 2 and figure 5]

#include <cmath>

#include "app/figures/solved.hpp"
#include "app/gnuplot/figure.hpp"

namespace steadyslide::app {

Figure make_parabola() {
  // psi = x^2/2, gamma = 1/2, f = 1. The radius R is 1.
  const Rational s(1, 2);
  const ContactProblem problem = parabola(0, {1}, Rational(1, 50));
  const auto solution = solved(problem);
  const auto load = numeric::to_real<double>(problem.load());
  const auto zone = solution->contact().front();
  const auto points = solution->singular_points();
  const double a = (zone.right.x.value - zone.left.x.value) / 2;
  const auto alpha = numeric::to_real<double>(Exponent::angle(s));

  Series profile{"indenter ψ", Look::line, 2, {}};
  Series surface{"surface {/:Italic u} + {/:Italic C}", Look::line, 1, {}};
  for (int i = -240; i <= 240; ++i) {
    const double x = i * a / 100;
    const numeric::Sample<double> sample = solution->at(Rational(x));
    profile.points.push_back({x / a, x * x / 2 / (a * a)});
    surface.points.push_back({x / a, (x * x / 2 - sample.gap->value) / (a * a)});
  }
  Series pressure{"closed form", Look::line, 1, {{-2.4, 0}, {zone.left.x.value / a, 0}}};
  for (const Point& p : pressure_curve(*solution, 301)) {
    if (std::isfinite(p.x)) pressure.points.push_back({p.x / a, p.y * a / load});
  }
  pressure.points.push_back({zone.right.x.value / a, 0});
  pressure.points.push_back({2.4, 0});
  Series cells{"on 4000 cells", Look::marks, 1, {}};
  for (const Point& p : pressure_of_cells(*solved_on_cells(problem, 4000), 25)) {
    cells.points.push_back({p.x / a, p.y * a / load});
  }

  const Axis across{"{/:Italic x} / {/:Italic a}", -2, 2, false, 0.5};
  Panel above{{0.1, 0.98, 0.56, 0.93}, across.bare(), {"height  ({/:Italic a}^2/{/:Italic R})", -0.2, 2, false, 0.5}};
  Panel below{
      {0.1, 0.98, 0.115, 0.52}, across, {"pressure −{/:Italic t}_n  ({/:Italic P}/{/:Italic a})", 0, 0.8, false, 0.2}};
  above.series = {profile, surface};
  above.legend = LegendAt::top_centre;
  below.series = {pressure, cells};
  below.legend = LegendAt::top_right;
  const double peak = -4 * alpha;
  for (const double x : {-(1 + 2 * alpha), peak, 1 - 2 * alpha}) {
    above.guides.push_back({{x, 0, false, true}, {x, 0.62, false, true}});
    below.guides.push_back({{x, 0, false, true}, {x, 1, false, true}});
  }
  below.notes = {{{-(1 + 2 * alpha) - 0.03, 0.9, false, true}, "−(1 + 2α){/:Italic a}", Align::right},
                 {{peak + 0.03, 0.09, false, true}, "−4α{/:Italic a}"},
                 {{1 - 2 * alpha + 0.03, 0.55, false, true}, "(1 − 2α){/:Italic a}"},
                 {{-(1 + 2 * alpha) - 0.03, 0.09, false, true}, exponent_text("½ − α", points.front()), Align::right},
                 {{1 - 2 * alpha + 0.03, 0.09, false, true}, exponent_text("½ + α", points.back())}};
  above.notes = {{{0.5, 0.42, true, true}, "sliding", Align::centre}};
  above.guides.push_back({{0.43, 0.34, true, true}, {0.57, 0.34, true, true}, true});
  return {
      "parabola",
      "A parabola slides: contact zone and pressure",
      "A rigid parabola `psi = x^2/(2R)` that slides to the right, `nu = 0`, `f = 1`, `alpha = arctan(1/2)/pi`: "
      "indenter and surface above, pressure below, lengths in units of the half-length `a` of the contact. The "
      "contact zone reaches from `-(1+2 alpha)a` to `(1-2 alpha)a`, the pressure is largest at `-4 alpha a`, in the "
      "rear half; all three are drawn from the formulas, curves and marks from the solutions.",
      640,
      {above, below}};
}

}  // namespace steadyslide::app
