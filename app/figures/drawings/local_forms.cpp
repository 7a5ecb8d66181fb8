// Pressure against the distance to a singular point. [Bal16, theorems 2, 3, 9 and 10]

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/figures/solved.hpp"
#include "app/gnuplot/figure.hpp"
#include "numeric/variational/local_fit.hpp"

namespace steadyslide::app {
namespace {

namespace variational = numeric::variational;
using VariationalPlace = numeric::VariationalSolution::SingularPlace;

constexpr std::size_t cells = 16384;

/// One problem, solved by both methods; all supports have their middle at 0.
struct Solved {
  explicit Solved(const ContactProblem& problem)
      : solution(solved_by_singular_functions(problem)), on_cells(solved_on_cells(problem, cells)) {}

  std::shared_ptr<const numeric::ContactSolution<double>> solution;
  std::shared_ptr<const numeric::VariationalSolution> on_cells;
};

/// A singular point, counted from the left, and the side from which the curve approaches it.
struct Seen {
  std::size_t point;
  Side side;
};

/// Distances in equal steps of their logarithm.
std::vector<double> distances(double from, double to, int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(from * std::pow(to / from, double(i) / (count - 1)));
  return result;
}

Series curve(const Solved& solved, const Seen& seen, int style) {
  Series series{"", Look::line, style, {}};
  const double c = solved.solution->singular_points()[seen.point].x.value;
  for (const double d : distances(1e-5, 0.2, 80)) {
    const Rational x = Rational(c) + (seen.side == Side::right ? Rational(d) : -Rational(d));
    series.points.push_back({d, -solved.solution->at(x).traction.left.value});
  }
  return series;
}

Series marks(const Solved& solved, const Seen& seen, int style) {
  Series series{"", Look::marks, style, {}};
  const double c = solved.solution->singular_points()[seen.point].x.value;
  const variational::Cells all = solved.on_cells->cells();
  const double cell = solved.on_cells->cell_length();
  for (const double d : distances(30 * cell, 0.2, 9)) {
    const double x = seen.side == Side::right ? c + d : c - d;
    const auto i = static_cast<std::size_t>((x - all.edges.front()) / cell);
    const double middle = (all.edges[i] + all.edges[i + 1]) / 2;
    series.points.push_back({std::abs(middle - c), -all.mean[i]});
  }
  return series;
}

/// "name: derived exponent, exponent fitted to the cells".
std::string legend(const std::string& name, const Solved& solved, const Seen& seen) {
  const VariationalPlace& place = solved.on_cells->places().at(seen.point);
  const auto known = place.exact ? variational::PlaceIs::exact : variational::PlaceIs::to_one_cell;
  if (!place.exponent) {
    const auto exact = solved.solution->singular_points().at(seen.point).intensity;
    const auto read = solved.on_cells->singular_points().at(seen.point).intensity;
    return fmt::format("{}: log, factor {}, cells {}", name, decimal(exact.value, 4), decimal(read.value, 4));
  }
  const auto found =
      variational::fitted_exponent(solved.on_cells->cells(), place.surroundings, seen.side, place.wedge_degree, known);
  return fmt::format("{}: {}, cells {}", name, decimal(numeric::to_real<double>(*place.exponent), 4),
                     decimal(found.exponent.value, 4));
}

void add(Panel& panel, const std::string& name, const Solved& solved, const Seen& seen, int style) {
  Series line = curve(solved, seen, style);
  Series mark = marks(solved, seen, style);
  line.legend = legend(name, solved, seen);
  for (const Series* series : {&line, &mark}) {
    const auto positive = [](const Point& p) { return p.x > 0 && p.y > 0; };
    if (!std::ranges::all_of(series->points, positive))
      throw std::runtime_error("no pressure next to a singular point");
  }
  panel.series.push_back(std::move(line));
  panel.series.push_back(std::move(mark));
}

}  // namespace

Figure make_local_forms() {
  const Rational nu(1, 5);
  const Solved rising(flat_punch(nu, {Rational(1, 10), 1}, {0}));
  const Solved falling(flat_punch(nu, {Rational(1, 10), 1}, {0}, Sliding::minus_x));
  const Solved punch(flat_punch(nu, {1}));
  const Elasticity body(Solid(nu, 1));
  const Solved under_parabola(parabola(nu, {1}, Rational(1, 8)));
  const Rational slope(1);
  const Solved wedge(
      {body, FrictionProfile({1}),
       Indenter(-1, {{0, Polynomial({0, -slope, Rational(1, 2)})}, {1, Polynomial({0, slope, Rational(1, 2)})}}), 1});

  const Axis distance{"distance {/:Italic d} / {/:Italic L}", 1e-5, 0.3, true};
  Panel strong{{0.095, 0.49, 0.34, 0.92},
               distance,
               {"pressure −{/:Italic t}_n  ({/:Italic P}/{/:Italic L}; wedge: {/:Italic E})", 0.1, 1000, true}};
  Panel weak{{0.59, 0.985, 0.34, 0.92},
             distance,
             {"pressure −{/:Italic t}_n  ({/:Italic E}; jump: {/:Italic P}/{/:Italic L})", 1e-4, 1, true}};
  strong.legend = LegendAt::below;
  weak.legend = LegendAt::below;
  add(strong, "edge, rear", punch, {0, Side::right}, 1);
  add(strong, "edge, front", punch, {1, Side::left}, 2);
  add(strong, "jump, rising", rising, {1, Side::right}, 4);
  add(strong, "wedge", wedge, {1, Side::right}, 3);
  add(weak, "free end, rear", under_parabola, {0, Side::right}, 1);
  add(weak, "free end, front", under_parabola, {1, Side::left}, 2);
  add(weak, "jump, falling", falling, {1, Side::right}, 4);
  return {"local-forms",
          "Pressure next to a singular point",
          "Pressure against the distance `d` to a singular point, `nu = 1/5`, `f = 1` (under the jumps 0.1 and 1). "
          "Lines by the singular functions, marks by the solver on 16384 cells, which knows none. The numbers are the "
          "derived power of `d` (of the logarithm its factor) and what is read off the cells by a fit that does not "
          "know it. Left what blows up: the edges of a flat punch, a friction jump up, a wedge; right what vanishes: "
          "the free ends under a parabola, a friction jump down. Units: `P/L` under the flat punches, `E` elsewhere.",
          560,
          {strong, weak}};
}

}  // namespace steadyslide::app
