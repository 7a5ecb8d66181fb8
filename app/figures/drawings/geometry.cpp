// What the problem is, drawn from two solved ones: tractions along the normal without friction and slanted by it with
// friction, and the half-plane under an obstacle. [Bal16, figures 1 and 2]

#include "app/figures/solved.hpp"
#include "app/gnuplot/figure.hpp"

namespace steadyslide::app {
namespace {

/// One unit is as long upwards as across: angles are those of the data. The y axis keeps its upper end.
void make_isotropic(Panel& panel, int height) {
  const Frame& frame = panel.frame;
  const double unit = 800 * (frame.right - frame.left) / (panel.x.to - panel.x.from);
  panel.y.from = panel.y.to - height * (frame.top - frame.bottom) / unit;
}

/// A problem on the support [-1, 1] under one polynomial, and its solution.
struct Scene {
  ContactProblem problem;
  std::shared_ptr<const numeric::ContactSolution<double>> solution = solved(problem);

  double profile(double x) const {
    return numeric::to_real<double>(problem.indenter().pieces().front().profile(Rational(x)));
  }
  double surface(double x) const { return profile(x) - solution->at(Rational(x)).gap->value; }

  Series profile_curve(const std::string& legend) const { return {legend, Look::line, 2, points(&Scene::profile)}; }
  Series surface_curve() const { return {"surface of the body", Look::line, 1, points(&Scene::surface)}; }

 private:
  std::vector<Point> points(double (Scene::*height)(double) const) const {
    std::vector<Point> result;
    for (int i = -200; i <= 200; ++i) result.push_back({i / 200.0, (this->*height)(i / 200.0)});
    return result;
  }
};

constexpr int tractions_height = 360;

/// The tractions on the body at seven places of the contact, as arrows.
Panel tractions(const Rational& f, const Frame& frame, const std::string& note) {
  // psi = x^2/2: its radius is the unit of length.
  const Scene scene{{Elasticity(Solid(0, 1)), FrictionProfile({f}),
                     Indenter(-1, {{1, Polynomial({0, 0, Rational(1, 2)})}}), Rational(1, 4)}};
  Panel panel{frame, {"{/:Italic x} / {/:Italic R}", -1, 1, false, 0.5}, {"", 0, 0.7, false, 0.5}};
  make_isotropic(panel, tractions_height);
  panel.series = {scene.profile_curve("obstacle −{/:Italic z} = ψ"), scene.surface_curve()};
  panel.legend = LegendAt::top_centre;

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
  Panel without = tractions(0, {0.1, 0.51, 0.2, 0.9}, "no friction: along the normal");
  without.y.label = "−{/:Italic z} / {/:Italic R}";
  Panel with = tractions(1, {0.575, 0.985, 0.2, 0.9}, "sliding, {/:Italic f} = 1: slanted by arctan {/:Italic f}");
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

Figure make_geometry() {
  constexpr int height = 480;
  constexpr double top = 0.6;
  const Rational jump(1, 5);
  const Scene scene{{Elasticity(Solid(Rational(1, 5), 1)), FrictionProfile({Rational(3, 10), 1}, {jump}),
                     Indenter(-1, {{1, Polynomial({0, 0, Rational(1, 3)})}}), Rational(1, 4)}};
  Panel panel{{0.1, 0.985, 0.125, 0.925},
              {"{/:Italic x} / {/:Italic L}", -1.45, 1.45, false, 0.5},
              {"−{/:Italic z} / {/:Italic L}", 0, 0.95, false, 0.5}};
  make_isotropic(panel, height);
  Series obstacle = scene.profile_curve("obstacle, −{/:Italic z} = ψ on [−{/:Italic L}, {/:Italic L}]");
  obstacle.points.insert(obstacle.points.begin(), {-1, top});
  obstacle.points.insert(obstacle.points.end(), {{1, top}, {-1, top}});
  Series contact{"contact", Look::line, 3, {}};
  const auto zone = scene.solution->contact().front();
  for (const double x : {zone.left.x.value, zone.right.x.value}) {
    contact.points.insert(contact.points.end(), {{x, -0.12}, {x, scene.surface(x)}, gap_in_curve});
  }
  panel.series = {obstacle, scene.surface_curve(), contact};
  panel.legend = LegendAt::top_right;

  const double c = numeric::to_real<double>(jump);
  panel.guides = {{{0, 0.9}, {0, top}, true},
                  {{0.3, 0.45}, {0.7, 0.45}, true},
                  {{-1.35, -0.1}, {-1.05, -0.1}, true},
                  {{-1.35, -0.1}, {-1.35, -0.4}, true},
                  {{c, scene.profile(c)}, {c, 0.3}}};
  panel.notes = {{{0.04, 0.78}, "{/:Italic P}"},
                 {{0.74, 0.45}, "{/:Italic w}"},
                 {{-1.02, -0.1}, "{/:Italic x}"},
                 {{-1.31, -0.38}, "{/:Italic z}"},
                 {{c - 0.06, 0.24}, "{/:Italic f}_{−}", Align::right},
                 {{c + 0.06, 0.24}, "{/:Italic f}_{+}"},
                 {{0, -0.4}, "elastic half-plane: {/:Italic E} = 1, ν", Align::centre}};
  return {
      "geometry",
      "The problem",
      "A rigid obstacle `-z = psi(x)`, `-L < x < L`, slides along the straight boundary of an elastic half-plane "
      "`z > 0` with the velocity `w` to the right, under the load `P`. Its friction coefficient may jump, here from "
      "`f_- = 0.3` to `f_+ = 1`. Drawn from a solution, to scale: `psi = x^2/(3L)`, `nu = 1/5`, `P = E L/4`. How "
      "deep the obstacle sits is not determined: displacements of a half-plane are, up to a constant.",
      height,
      {panel}};
}

}  // namespace steadyslide::app
