#include <fmt/format.h>

#include <algorithm>

#include "app/gnuplot/figure.hpp"

namespace steadyslide::app {
namespace {

/// The last cell [x_i, x_i+1] of a grid that begins at or before a place, and the part of it before that place.
struct GridPlace {
  std::size_t i;
  double part;

  GridPlace(const std::vector<double>& grid, double at) {
    const auto above = std::upper_bound(grid.begin() + 1, grid.end() - 1, at);
    i = static_cast<std::size_t>(above - grid.begin()) - 1;
    part = (at - grid[i]) / (grid[i + 1] - grid[i]);
  }
};

double interpolated(const HeatMap& map, const Point& at) {
  const GridPlace x(map.x, at.x), y(map.y, at.y);
  const auto value = [&](std::size_t i, std::size_t j) { return map.values[j * map.x.size() + i]; };
  const auto across = [&](std::size_t j) { return (1 - x.part) * value(x.i, j) + x.part * value(x.i + 1, j); };
  return (1 - y.part) * across(y.i) + y.part * across(y.i + 1);
}

}  // namespace

std::vector<Note> contour_labels(const HeatMap& map, const Point& from, const Point& to) {
  constexpr int steps = 1000;
  std::vector<Note> labels;
  double before = interpolated(map, from);
  for (int k = 1; k <= steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    const Point at{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
    const double value = interpolated(map, at);
    for (const double level : map.contours) {
      if ((before < level) == (value < level)) continue;
      const std::string text = fmt::format("{}", level);
      labels.push_back({{at.x, at.y}, level < 0 ? "−" + text.substr(1) : text, Align::centre, 11, true});
    }
    before = value;
  }
  return labels;
}

}  // namespace steadyslide::app
