// Tractions on the body, along the normal without friction and slanted by it with friction. [Bal16, figure 1]

#include "app/figures/scene.hpp"

namespace steadyslide::app {
namespace {

constexpr int tractions_height = 420;

/// The tractions on the body at seven places of the contact, as arrows.
Panel tractions(const Rational& f, const Frame& frame, const std::string& note) {
  // psi = x^2/2. Its radius is the unit of length.
  const Scene scene{parabola(0, {f}, Rational(1, 4))};
  Panel panel{frame, {"{/:Italic x} / {/:Italic R}", -1, 1, false, 0.5}, {"", 0, 0.7, false, 0.5}};
  make_isotropic(panel, tractions_height);
  panel.series = {{"obstacle −{/:Italic z} = ψ", Look::line, 2, scene.profile_curve(-1, 1)},
                  {"surface of the body", Look::line, 1, scene.surface_curve(-1, 1)}};
  panel.legend = LegendAt::none;

  const auto zone = scene.solution->contact().front();
  constexpr int arrows = 7;
  constexpr double length_of_one = 1.6;
  for (int i = 1; i <= arrows; ++i) {
    const double x = zone.left.x.value + i * (zone.right.x.value - zone.left.x.value) / (arrows + 1);
    const numeric::Sample<double> at = scene.solution->at(Rational(x));
    const Point from{x, scene.surface(x)};
    panel.guides.push_back(
        {{from.x, from.y},
         {from.x + length_of_one * at.shear.left.value, from.y + length_of_one * at.traction.left.value},
         true});
  }
  panel.notes = {{{0.5, 0.04, true, true}, note, Align::centre}};
  return panel;
}

}  // namespace

Figure make_reactions() {
  Panel without = tractions(0, {0.1, 0.51, 0.305, 0.905}, "no friction: along the normal");
  without.legend = LegendAt::below;
  without.y.label = "−{/:Italic z} / {/:Italic R}";
  Panel with = tractions(1, {0.575, 0.985, 0.305, 0.905}, "sliding, {/:Italic f} = 1: slanted by arctan {/:Italic f}");
  with.y.labelled = false;
  with.guides.push_back({{-0.15, 0.32}, {0.15, 0.32}, true});
  with.notes.push_back({{0.19, 0.32}, "{/:Italic w}"});
  return {"reactions",
          "What a sliding obstacle exerts on the body",
          "A rigid parabola `psi = x^2/(2R)` presses on an elastic half-plane, `nu = 0`: at rest without friction, and "
          "sliding to the right with the velocity `w` and `f = 1`. The arrows are the tractions on the body, `t_n` "
          "downwards and `t_t = -f t_n` along `w`, both from the solutions, lengths and angles to scale. Sliding, the "
          "direction of the traction is known at every point of the contact, as it is without friction.",
          tractions_height,
          {without, with}};
}

}  // namespace steadyslide::app
