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

std::vector<FamilyMember> family(const Cells& cells, const LocalPlace& place, std::span<const Side> sides,
                                 bool crowded) {
  double cell = 0;
  double reach = std::numeric_limits<double>::infinity();
  for (const Side side : sides) {
    cell = std::max(cell, cell_length(cells, place.x, side));
    const bool right = side == Side::right;
    reach = std::min({reach, right ? place.right : place.left, 4 * (right ? place.left : place.right),
                      right ? cells.edges.back() - place.x : place.x - cells.edges.front()});
  }
  std::vector<FamilyMember> result;
  for (const double part : {0.3, 0.4, 0.5}) {
    for (const double from : {10., 16., 24.}) {
      const Window window{from * cell, part * reach};
      if (window.to < 6 * window.from || (crowded && from == 10)) continue;
      for (const int terms : {7, 9, 11}) {
        result.push_back({window, 2, terms});
        if (!crowded) result.push_back({window, 3, terms});
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
  const std::size_t asked = values.size();
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.size() < 3 || 3 * values.size() < 2 * asked) {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), Convergence::stalled};
  }
  std::sort(values.begin(), values.end());
  return {values[values.size() / 2], values.back() - values.front(), Convergence::reached};
}

Estimate<double> moved_place(const Cells& cells, double start, Side side, double x, const Estimate<double>& step) {
  if (step.convergence == Convergence::stalled) return {start, step.error, Convergence::stalled};
  const double most = 2 * cell_length(cells, start, side);
  return {std::clamp(x - step.value, start - most, start + most), step.error};
}

}  // namespace steadyslide::numeric::variational
