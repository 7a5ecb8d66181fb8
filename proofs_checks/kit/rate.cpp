#include "proofs_checks/kit/rate.hpp"

#include <cmath>
#include <limits>

namespace steadyslide::proofs_checks {

Rate fitted_rate(std::span<const Level> levels) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto n = static_cast<double>(levels.size());
  if (levels.size() < 3) return {nan, nan};
  double x_mean = 0;
  double y_mean = 0;
  for (const Level& level : levels) {
    if (!(level.error > 0 && std::isfinite(level.error))) return {nan, nan};
    x_mean += std::log(level.cells) / n;
    y_mean += std::log(level.error) / n;
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (const Level& level : levels) {
    const double x = std::log(level.cells) - x_mean;
    const double y = std::log(level.error) - y_mean;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const double slope = xy / xx;
  return {-slope, std::sqrt(std::fmax(yy - slope * xy, 0) / ((n - 2) * xx))};
}

double root_mean_square(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace steadyslide::proofs_checks
