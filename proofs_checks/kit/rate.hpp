#pragma once
// The power of the number of cells with which an error falls: log(error) = constant - rate log(cells) by least squares,
// all levels with the same weight.

#include <span>

namespace steadyslide::proofs_checks {

/// The error on meshes of about this many cells.
struct Level {
  double cells;
  double error;
};

struct Rate {
  double value;
  double error_bar;  ///< one standard deviation, from the residuals of the fitted line
};

/// Returns the rate and its error bar. They are NaN if there are fewer than three levels or an error is not positive
/// and finite.
Rate fitted_rate(std::span<const Level> levels);

/// Returns the root of the mean square.
double root_mean_square(std::span<const double> values);

}  // namespace steadyslide::proofs_checks
