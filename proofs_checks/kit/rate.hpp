#pragma once
// The power with which an error falls: log(error) = constant - rate log(cells) by least squares, all levels alike.

#include <span>

namespace steadyslide::proofs_checks {

/// An error on meshes of about so many cells.
struct Level {
  double cells;
  double error;
};

struct Rate {
  double value;
  double error_bar;  ///< one standard deviation, from what the line leaves over
};

/// Not numbers with fewer than three levels, or where an error is not positive and finite.
Rate fitted_rate(std::span<const Level> levels);

/// Root of the mean square.
double root_mean_square(std::span<const double> values);

}  // namespace steadyslide::proofs_checks
