// Two bumps: pressure and surface at several loads, until the two contact zones become one.

#include <fmt/format.h>

#include "app/figures/solved.hpp"

namespace steadyslide::app {
namespace {

Rational bump_height(const Rational& x) { return (x * x - 1) * (x * x - 1) / 4; }

}  // namespace

Figure make_two_zones() {
  const ContactProblem bumps = two_bumps();
  const double edge = 1.9;
  const Axis across{"{/:Italic x} / {/:Italic L}", -edge, edge, false, 0.5};
  Panel above{{0.1, 0.98, 0.629, 0.935}, across.bare(), {"height  ({/:Italic L})", -0.15, 0.5, false, 0.2}};
  Panel below{{0.1, 0.98, 0.181, 0.598}, across, {"pressure −{/:Italic t}_n  ({/:Italic E})", 0, 0.75, false, 0.2}};
  above.legend = LegendAt::none;
  below.legend = LegendAt::row_below;
  Series profile{"bumps ψ", Look::line, 6, {}};
  for (int i = -190; i <= 190; ++i) {
    const Rational x(i, 100);
    profile.points.push_back({numeric::to_real<double>(x), numeric::to_real<double>(bump_height(x))});
  }
  above.series.push_back(std::move(profile));

  int style = 0;
  std::shared_ptr<const numeric::RiemannHilbertSolution<double>> solution;
  for (const Rational& load : {Rational(1, 10), Rational(4, 10), Rational(77, 100), Rational(11, 10)}) {
    solution = solved_by_singular_functions(bumps.with_load(load), solution.get());
    ++style;
    const std::size_t zones = solution->contact().size();
    below.series.push_back({fmt::format("{{/:Italic P}} = {} {{/:Italic E L}}, {}", to_string(load),
                                        zones == 1 ? "one zone" : "two zones"),
                            Look::line, style, pressure_curve(*solution, 301)});
    Series surface{below.series.back().legend, Look::line, style, {}};
    for (int i = -190; i <= 190; ++i) {
      const Rational x(i, 100);
      const double gap = solution->at(x).gap->value;
      surface.points.push_back({numeric::to_real<double>(x), numeric::to_real<double>(bump_height(x)) - gap});
    }
    above.series.push_back(std::move(surface));
  }
  const auto points = solution->singular_points();
  for (Panel* panel : {&above, &below}) panel->guides.push_back({{0, 0, false, true}, {0, 1, false, true}});
  below.notes = {{{0.03, 0.27, false, true}, exponent_text("β", points[1]), Align::centre, 14, true}};
  above.notes = {{{0.5, 0.88, true, true}, "sliding", Align::centre},
                 {{-0.04, 0.685, false, true}, "{/:Italic f} = 0.1", Align::right},
                 {{0.04, 0.685, false, true}, "{/:Italic f} = 0.7"}};
  above.guides.push_back({{0.43, 0.78, true, true}, {0.57, 0.78, true, true}, true});
  return {
      "two-zones",
      "Two contact zones become one",
      "Two bumps `psi = (x^2-1)^2/4` slide to the right, `f = 0.1` on the left of 0 and 0.7 on the right, `nu = "
      "3/10`; `L` is the unit of length, `E` Young's modulus. Above the bumps and the surface below them at four "
      "loads, below the pressure. Up to a load of about 0.77 there are two zones with free ends, and no contact where "
      "friction jumps; then the zones are one, and the pressure is infinite at the jump like `|x|^beta`.",
      690,
      {above, below}};
}

}  // namespace steadyslide::app
