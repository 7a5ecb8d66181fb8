// The problem: half-plane, indenter, load, direction of sliding, friction with a jump, contact. [Bal16, figure 2]

#include "app/figures/scene.hpp"

namespace steadyslide::app {

Figure make_sketch() {
  constexpr int height = 400;
  constexpr double edge = 1.75, top = 0.66, level = -0.2;
  const Rational jump(1, 5);
  const Scene scene{{Elasticity(Solid(Rational(1, 5), 1)), FrictionProfile({Rational(3, 10), 1}, {jump}),
                     Indenter(-2, {{2, Polynomial({0, 0, Rational(1, 3)})}}), Rational(1, 4)}};
  Panel panel{{0.005, 0.995, 0.01, 0.93}, {"", -edge, edge}, {"", 0, 1.06}};
  make_isotropic(panel, height);
  panel.bare = true;
  panel.legend = LegendAt::none;

  const double c = numeric::to_real<double>(jump);
  const auto zone = scene.solution->contact().front();
  const double a = zone.left.x.value, b = zone.right.x.value;
  const Series surface{"surface", Look::line, 1, scene.surface_curve(-edge, edge)};
  Series body{"body", Look::area, 1, surface.points};
  body.points.insert(body.points.end(), {{edge, panel.y.from}, {-edge, panel.y.from}});
  Series indenter{"indenter", Look::area, 3, scene.profile_curve(-1, 1)};
  indenter.points.insert(indenter.points.end(), {{1, top}, {-1, top}});
  panel.series = {body,
                  indenter,
                  surface,
                  {"first coating", Look::band, 7, scene.profile_curve(-1, c)},
                  {"second coating", Look::band, 2, scene.profile_curve(c, 1)}};

  panel.guides = {
      {{0, 1.02}, {0, top}, true},        {{0.42, 0.5}, {0.8, 0.5}, true}, {{-1.62, level}, {1.62, level}, true},
      {{0, level}, {0, -0.58}, true},     {{c, level}, {c, 0.38}},         {{a, level}, {a, scene.surface(a)}},
      {{b, level}, {b, scene.surface(b)}}};
  constexpr int size = 20;
  panel.notes = {{{0.05, 0.88}, "load {/:Italic P}", Align::left, size},
                 {{0.4, 0.5}, "sliding", Align::right, size},
                 {{-0.95, 0.5}, "rigid indenter", Align::left, size},
                 {{c - 0.08, 0.2}, "friction {/:Italic f}_{−}", Align::right, size},
                 {{c + 0.08, 0.2}, "{/:Italic f}_{+}", Align::left, size},
                 {{1.66, level}, "{/:Italic x}", Align::left, size},
                 {{0.05, -0.53}, "{/:Italic z}", Align::left, size},
                 {{a, level - 0.09}, "{/:Italic a}", Align::centre, size},
                 {{c, level - 0.09}, "{/:Italic c}", Align::centre, size},
                 {{b, level - 0.09}, "{/:Italic b}", Align::centre, size},
                 {{-1.6, -0.5}, "elastic half-plane {/:Italic E}, ν", Align::left, size}};
  Figure figure{
      "sketch",
      "A rigid indenter slides steadily over an elastic half-plane",
      "A rigid indenter `-z = psi(x)` slides along the straight boundary of an elastic half-plane `z > 0` to the "
      "right, under the load `P`. Its friction coefficient jumps at `c` from `f_-` to `f_+`; the contact from `a` to "
      "`b` is unknown. Drawn from a solution, to scale: `psi = x^2/(3L)`, `nu = 1/5`, `P = E L/4`, `f_- = 0.3`, `f_+ "
      "= 1`, `c = L/5`. How deep the indenter sits is not determined: displacements of a half-plane are, up to a "
      "constant.",
      height,
      {panel}};
  figure.digits = 5;  // a test compares the copy in docs/
  return figure;
}

}  // namespace steadyslide::app
