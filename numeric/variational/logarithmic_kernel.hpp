#pragma once
// Exact means of the logarithm over pairs of cells, Galerkin's matrix of -(1/pi) t * log|x|:
//
//   mean_log(a, b, c, d) = 1/((b-a)(d-c)) int_a^b int_c^d log|x - y| dy dx.

#include <cstddef>

namespace steadyslide::numeric::variational {

/// Two cells that are the same, meet, or are apart; none cuts into another. To about 1e-15, whatever the ratio of the
/// lengths and of the distance to them.
double mean_log(double a, double b, double c, double d);

/// The same over two cells of length 1 whose centres are k apart, to the last digits for every k.
double mean_log_of_unit_cells(std::size_t k);

/// The mean of log|u - v| over |v| < 1/2: a cell of length 1 seen from a point.
double mean_log_from_point(double u);

}  // namespace steadyslide::numeric::variational
