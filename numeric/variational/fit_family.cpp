#include "numeric/variational/fit_family.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::numeric::variational {

double cell_length(const Cells& cells, double place, Side side) {
  const auto after = std::upper_bound(cells.edges.begin() + 1, cells.edges.end() - 1, place);
  // On an edge: the cell to its right, the one to its left.
  const auto right =
      side == Side::left && *(after - 1) == place && after - 1 != cells.edges.begin() ? after - 1 : after;
  return *right - *(right - 1);
}

std::vector<FamilyMember> family(const Cells& cells, const LocalPlace& place, std::span<const Side> sides) {
  double cell = 0;
  double reach = std::numeric_limits<double>::infinity();
  for (const Side side : sides) {
    cell = std::max(cell, cell_length(cells, place.x, side));
    const bool right = side == Side::right;
    reach = std::min({reach, right ? place.right : place.left, 4 * (right ? place.left : place.right),
                      right ? cells.edges.back() - place.x : place.x - cells.edges.front()});
  }
  std::vector<FamilyMember> result;
  for (const double part : {0.4, 0.5, 0.6}) {
    for (const double from : {8., 12., 18.}) {
      const Window window{from * cell, part * reach};
      if (window.to < 6 * window.from) continue;
      for (const int poles : {1, 2}) {
        for (const int terms : {6, 8, 10}) result.push_back({window, poles, terms});
      }
    }
  }
  return result;
}

std::vector<Bin> gathered(const Cells& cells, double place, std::span<const Side> sides, const Window& window) {
  std::vector<Bin> result;
  for (const Side side : sides) {
    const std::vector<Bin> bins = gathered(cells, place, side, window);
    if (bins.empty()) return {};
    result.insert(result.end(), bins.begin(), bins.end());
  }
  return result;
}

Estimate<double> summary(std::vector<double> values) {
  if (values.size() < 3) {
    return {values.empty() ? std::numeric_limits<double>::quiet_NaN() : values.front(),
            std::numeric_limits<double>::infinity(), Convergence::stalled};
  }
  std::sort(values.begin(), values.end());
  return {values[values.size() / 2], values.back() - values.front(), Convergence::reached};
}

}  // namespace steadyslide::numeric::variational
