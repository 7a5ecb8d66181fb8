// The problem: half-plane, indenter, load, direction of sliding, friction with a jump, contact. [Bal16, figure 2]

#include "app/figures/scene.hpp"

namespace steadyslide::app {

Figure make_sketch() {
  constexpr int height = 420;
  constexpr double edge = 1.75, top = 0.92;
  const Rational jump(1, 5);
  const Scene scene{{Elasticity(Solid(Rational(1, 5), 1)), FrictionProfile({Rational(3, 10), 1}, {jump}),
                     Indenter(-2, {{2, Polynomial({0, 0, Rational(1, 3)})}}), Rational(1, 4)}};
  Panel panel{{0.005, 0.995, 0.01, 0.93}, {"", -edge, edge}, {"", 0, 1.32}};
  make_isotropic(panel, height);
  panel.bare = true;
  panel.legend = LegendAt::none;

  // The displacements are known up to a constant: z = 0 is the mean height of the surface's two ends.
  const double level = (scene.surface(-edge) + scene.surface(edge)) / 2;
  const auto c = numeric::to_real<double>(jump);
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

  panel.guides = {{{0, 1.28}, {0, top}, true},    {{0.42, 0.82}, {0.8, 0.82}, true},
                  {{-edge, level}, {1.6, level}}, {{1.6, level}, {1.7, level}, true},
                  {{0, level}, {0, -0.28}},       {{0, -0.28}, {0, -0.38}, true}};
  for (const double x : {a, b, c}) panel.guides.push_back({{x, scene.profile(x)}, {x, level + (x == c ? 0.33 : 0)}});
  constexpr int size = 20;
  panel.notes = {{{0.05, 1.13}, "load {/:Italic P}", Align::left, size},
                 {{0.4, 0.82}, "sliding", Align::right, size},
                 {{-0.95, 0.82}, "rigid indenter", Align::left, size},
                 {{c - 0.06, level + 0.26}, "friction {/:Italic f}_{−} = 0.3", Align::right, size},
                 {{c + 0.06, level + 0.26}, "{/:Italic f}_{+} = 1", Align::left, size},
                 {{1.64, level + 0.09}, "{/:Italic x}", Align::left, size},
                 {{-1.72, level + 0.07}, "{/:Italic z} = 0", Align::left, size},
                 {{0.05, -0.33}, "{/:Italic z}", Align::left, size},
                 {{a, level + 0.07}, "{/:Italic a}", Align::centre, size},
                 {{c + 0.06, level + 0.07}, "{/:Italic c}", Align::left, size},
                 {{b, level + 0.07}, "{/:Italic b}", Align::centre, size},
                 {{-1.6, -0.28}, "elastic half-plane {/:Italic E}, ν", Align::left, size}};
  Figure figure{
      "sketch",
      "A rigid indenter slides steadily over an elastic half-plane",
      "A rigid indenter slides along the boundary `z = 0` of an elastic half-plane `z > 0` to the right, under the load "
      "`P` per unit of thickness. Its two coatings have the friction coefficients `f_-` and `f_+`, which change at `c`; "
      "the contact from `a` to `b` is unknown. Drawn from a solution, to scale: `psi = x^2/(3L)`, `nu = 1/5`, `P = E "
      "L/4`, `f_- = 0.3`, `f_+ = 1`, `c = L/5`. Displacements of a half-plane are known up to a constant; here the "
      "mean of the surface's heights at the two ends of the picture is 0.",
      height,
      {panel}};
  figure.digits = 5;  // a test compares the copy in docs/
  return figure;
}

}  // namespace steadyslide::app
