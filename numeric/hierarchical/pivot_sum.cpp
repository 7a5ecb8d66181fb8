#include "numeric/hierarchical/pivot_sum.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::numeric::hierarchical {
namespace {

/// Returns the number K of terms to sum in a series of powers of this ratio. The rest, K ratio^K, is below 2^-52.
std::size_t terms_for(double ratio) {
  const int halvings = -std::ilogb(std::abs(ratio)) - 1;
  return halvings < 2 ? CellMoments::terms : static_cast<std::size_t>(1 + 57 / std::min(halvings, 57));
}

}  // namespace

void PivotSum::add(std::size_t cell, Side side, int sigma, const Distances& nearest, std::vector<double>& sums) const {
  const double h = moments_.tree().cells()[cell].extent / 2;
  const double to_x = h + nearest.x;
  const double to_pivot = h + nearest.pivot;
  const double sign = side == Side::left ? 1 : -1;
  const double r = sign * h / to_x;
  const double q = sign * h / to_pivot;
  CellMoments::Series series;
  const std::size_t count = terms_for(h / std::min(to_x, to_pivot));
  if (sigma > 0) {
    double power = series[0] = 1 / (to_x * to_pivot);
    for (std::size_t k = 1; k < count; ++k) series[k] = r * series[k - 1] + (power *= q);
  } else {
    series[0] = sigma < 0 ? to_pivot / to_x : 1 / to_x;
    if (count > 1) series[1] = series[0] * (sigma < 0 ? r - q : r);
    for (std::size_t k = 2; k < count; ++k) series[k] = r * series[k - 1];
  }
  const std::size_t last = sums.size() - 1;
  const double value_sign = sigma == 0 ? -sign : 1;
  for (std::size_t s = 0; s < last; ++s) sums[s] += value_sign * moments_.weighted(cell, s, series, count);
  sums[last] += moments_.weighted(cell, last, series, count);
}

}  // namespace steadyslide::numeric::hierarchical
