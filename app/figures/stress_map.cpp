#include "app/figures/stress_map.hpp"

#include <algorithm>
#include <cmath>

#include "app/figures/solved.hpp"
#include "numeric/interior/surface_stress.hpp"

namespace steadyslide::app {
namespace {

constexpr int rows = 160;
constexpr int columns = 320;

}  // namespace

double surface_error(const numeric::ContactSolution<double>& solution, const ContactProblem& problem,
                     const Rational& z) {
  const numeric::InteriorStress<double> interior(solution);
  double worst = 0;
  for (const double x : {-0.75, -0.5, -0.25, 0.25, 0.5, 0.75}) {
    const numeric::StressState<double> above = surface_stress(problem.elasticity(), solution.details_at(Rational(x)));
    const numeric::StressState<double> below = interior.at(Rational(x), z);
    worst = std::max({worst, std::abs(above.zz.value - below.zz.value), std::abs(above.xz.value - below.xz.value)});
  }
  return worst;
}

Panel stress_panel(const numeric::ContactSolution<double>& solution, const ContactProblem& problem,
                   const MapView& view) {
  const numeric::InteriorStress<double> interior(solution);
  HeatMap map{{}, {}, {}, 0, view.highest, "von Mises stress  (" + view.stress_name + ")", view.contours};
  std::vector<double> x;
  // Stresses at the middles of pixels: a singular point in the middle of the surface lies between two of them.
  for (int i = 0; i < columns; ++i) {
    map.x.push_back(view.width * (2 * (i + 0.5) / columns - 1));
    x.push_back(view.length * map.x.back());
  }
  std::vector<numeric::StressState<double>> states(columns);
  for (int j = 0; j <= rows; ++j) {
    map.y.push_back(view.depth * j / rows);
    if (j == 0) {
      std::ranges::transform(x, states.begin(), [&](double at) {
        return surface_stress(problem.elasticity(), solution.details_at(Rational(at)));
      });
    } else {
      interior.at(x, std::vector(columns, view.length * map.y.back()), states);
    }
    for (const auto& state : states) map.values.push_back(state.von_mises()->value / view.stress);
  }
  Panel panel{{0.085, 0.86, 0.15, 0.85},
              {"{/:Italic x} / " + view.length_name, -view.width, view.width, false, view.width / 4},
              {"depth {/:Italic z} / " + view.length_name, view.depth, 0, false, 0.5}};
  panel.legend = LegendAt::none;
  panel.map = std::move(map);
  return panel;
}

numeric::LargestStress<double> mark_largest(Panel& panel, const numeric::ContactSolution<double>& solution,
                                            const MapView& view, double depth) {
  const auto largest = numeric::largest_stress(numeric::InteriorStress<double>(solution), depth).value();
  const Point at{largest.x.value / view.length, largest.z.value / view.length};
  panel.series.push_back({"largest", Look::marks, 8, {at}});
  const int outwards = at.x < 0 ? -1 : 1;
  panel.notes.push_back({{at.x + outwards * 0.03 * view.width, at.y + 0.02 * view.depth},
                         "largest: " + decimal(largest.von_mises.value / view.stress, 3),
                         at.x < 0 ? Align::right : Align::left,
                         13,
                         true});
  return largest;
}

}  // namespace steadyslide::app
