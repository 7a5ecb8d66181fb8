// Von Mises' stress in the body under a flat punch with two coatings.

#include "app/figures/stress_map.hpp"

#include <algorithm>
#include <cmath>

#include "app/figures/solved.hpp"
#include "app/gnuplot/figure.hpp"

namespace steadyslide::app {
namespace {

constexpr double half_width = 2;
constexpr double depth = 2;
constexpr int rows = 160;
constexpr int columns = 320;
constexpr double highest = 1.2;

/// The middle of a pixel. The singular points -1, 0, 1 of the surface lie between two of them.
double abscissa(int i) { return half_width * (2 * (i + 0.5) / columns - 1); }

}  // namespace

ContactProblem stress_map_problem() { return flat_punch(Rational(1, 5), {Rational(1, 10), 1}, {0}); }

numeric::StressState<double> surface_stress(const numeric::RiemannHilbertSolution<double>& solution,
                                            const ContactProblem& problem, double x) {
  const Rational place(x);
  const numeric::Sample<double> sample = solution.at(place);
  const double gamma = numeric::to_real<double>(problem.elasticity().gamma());
  const double c = numeric::to_real<double>(problem.elasticity().compliance());
  const double nu = numeric::to_real<double>(problem.elasticity().half_space()->poisson());
  const double t = sample.traction.left.value;
  numeric::StressState<double> stress;
  stress.xx.value = (1 - 2 * gamma) * t + 2 * solution.tangential_slope(place).value / c;
  stress.zz.value = t;
  stress.xz.value = -sample.shear.left.value;
  stress.yy = nu * (stress.xx + stress.zz);
  return stress;
}

double surface_error(const numeric::RiemannHilbertSolution<double>& solution, const ContactProblem& problem,
                     const Rational& z) {
  const numeric::InteriorStress<double> interior(solution);
  double worst = 0;
  for (const double x : {-0.75, -0.5, -0.25, 0.25, 0.5, 0.75}) {
    const numeric::StressState<double> above = surface_stress(solution, problem, x);
    const numeric::StressState<double> below = interior.at(Rational(x), z);
    worst = std::max({worst, std::abs(above.zz.value - below.zz.value), std::abs(above.xz.value - below.xz.value)});
  }
  return worst;
}

Figure make_stress_map() {
  const ContactProblem problem = stress_map_problem();
  const auto solution = solved_by_singular_functions(problem);
  const numeric::InteriorStress<double> interior(*solution);
  HeatMap map{
      {}, {}, {}, highest, "von Mises stress  ({/:Italic P}/{/:Italic L})", {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8}};
  for (int i = 0; i < columns; ++i) map.x.push_back(abscissa(i));
  for (int j = 0; j <= rows; ++j) {
    const double z = depth * j / rows;
    map.y.push_back(z);
    for (const double x : map.x) {
      const auto stress = j == 0 ? surface_stress(*solution, problem, x) : interior.at(Rational(x), Rational(z));
      map.values.push_back(stress.von_mises()->value);
    }
  }
  Panel panel{{0.085, 0.86, 0.15, 0.85},
              {"{/:Italic x} / {/:Italic L}", -half_width, half_width, false, 0.5},
              {"depth {/:Italic z} / {/:Italic L}", depth, 0, false, 0.5}};
  panel.legend = LegendAt::none;
  panel.map = std::move(map);
  panel.notes = {{{-0.5, 1.035, false, true}, "{/:Italic f} = 0.1", Align::centre},
                 {{0.5, 1.035, false, true}, "{/:Italic f} = 1", Align::centre},
                 {{1.2, 1.035, false, true}, "sliding"}};
  for (const double x : {-1.0, 0.0, 1.0}) panel.guides.push_back({{x, 1, false, true}, {x, 1.06, false, true}});
  panel.guides.push_back({{1.55, 1.035, false, true}, {1.9, 1.035, false, true}, true});
  // Rounded up.
  const double error = std::ceil(1e4 * surface_error(*solution, problem, Rational(1, 1000))) / 1e4;
  return {
      "stress-map",
      "Stress below a flat punch with two coatings",
      "Von Mises' stress in units of `P/L` (white 0, black " + decimal(highest, 1) +
          " and more) below a flat punch on `]-1, 1[` that slides to the right, `f = 0.1` on its left half and 1 on "
          "its right one, `nu = 1/5`; lines at 0.1 to 0.6 and 0.8. The row at the surface is made from the tractions "
          "and from the slope of the tangential displacement. At the depth `z = 0.001 L`, at a distance of 0.25 "
          "from the singular points, `sigma_{zz}` and `sigma_{xz}` differ from `t_n` and `-t_t` by at most " +
          decimal(error, 4) + " in these units.",
      450,
      {panel}};
}

}  // namespace steadyslide::app
