// A measured profile as the solver sees it: trace, contact zones, pressure (examples/rough_surface.toml).

#include <fmt/format.h>

#include <algorithm>

#include "app/embedded.hpp"
#include "app/figures/solved.hpp"
#include "library/problem_file/profile_trace.hpp"

namespace steadyslide::app {

Figure make_rough_surface() {
  const library::ProfileTrace trace =
      library::parse_trace(embedded::rough_surface_csv, "rough_surface.csv", std::nullopt);
  const Indenter shape(trace.range.left, trace.pieces);
  const ContactProblem problem{Elasticity(Solid(Rational(3, 10), 1)),
                               FrictionProfile({Rational(1, 10), Rational(4, 10)}, {0}), shape, Rational(3, 100)};
  const auto solution = solved_on_cells(problem, 65536);
  const auto zones = solution->contact();

  const Axis across{"{/:Italic x} / {/:Italic L}", -0.55, 0.45, false, 0.1};
  Panel above{{0.12, 0.98, 0.571, 0.914}, across.bare(), {"height  ({/:Italic L})", -0.0125, 0.023, false, 0.01}};
  Panel below{{0.12, 0.98, 0.114, 0.531}, across, {"pressure −{/:Italic t}_n  ({/:Italic E})", 0, 0.35, false, 0.1}};
  above.legend = LegendAt::row_above;
  below.legend = LegendAt::none;

  Series profile{"trace ψ", Look::line, 2, {}};
  Series surface{"surface {/:Italic u} + {/:Italic C}", Look::line, 1, {}};
  for (const Indenter::Piece& piece : shape.pieces()) {
    const auto x = numeric::to_real<double>(piece.to);
    if (x < across.from || x > across.to) continue;
    const auto psi = numeric::to_real<double>(piece.profile(piece.to));
    profile.points.push_back({x, psi});
    surface.points.push_back({x, psi - solution->at(piece.to).gap->value});
  }
  Series bars{fmt::format("{} contact zones", zones.size()), Look::bar, 3, {}};
  for (const auto& zone : zones) {
    for (const auto& end : {zone.left, zone.right}) bars.points.push_back({end.x.value, -0.0115});
  }
  above.series = {profile, surface, bars};
  below.series = {{"pressure", Look::line, 1, pressure_curve(*solution, 60)}};
  for (Panel* panel : {&above, &below}) panel->guides.push_back({{0, 0, false, true}, {0, 1, false, true}});
  above.notes = {{{-0.01, 0.9, false, true}, "{/:Italic f} = 0.1", Align::right},
                 {{0.01, 0.9, false, true}, "{/:Italic f} = 0.4"}};
  below.notes = {{{0.97, 0.93, true, true}, "sliding", Align::right}};
  below.guides.push_back({{0.87, 0.85, true, true}, {0.97, 0.85, true, true}, true});
  Figure figure{
      "rough-surface",
      "A rough trace under load, with two coatings",
      fmt::format(
          "The rough slider of `examples/rough_surface.toml`: {} heights of a trace like a measured one, joined by "
          "straight lines, under the load `P = 0.03 E L`, `nu = 3/10`, `f = 0.1` on the left of 0 and 0.4 on the "
          "right, solved on 65536 cells. Above the trace and the surface below it, with bars where they touch, in {} "
          "zones; below the pressure. Effective friction {:.4f}.",
          trace.points, zones.size(), solution->resultants().effective_friction.value),
      652,
      {above, below}};
  figure.digits = 5;  // a test compares the copy in docs/
  return figure;
}

}  // namespace steadyslide::app
