#pragma once
// The local forms of the traction next to a singular point c, fitted to means over cells by linear least squares. With
// y = x - c, d = |y|, H(y) = 1 for y > 0 and 0 for y < 0:
//
//   power:      t = a |y|^lambda sum c_k y^k + sum r_j y^j,             k = -poles..terms, j = 0..remainder
//   logarithm:  t = sum c_k y^k + sum r_j y^j (log|y|/pi + s H(y)),     the same
//
// a = left_factor for y < 0, right_factor for y > 0. The terms k >= 0 are the local form of the solution [Bal16,
// theorems 2, 3 and 9], the c_k the same on both sides. The terms k < 0 solve the equation without load next to c as
// well, with too much energy for a solution: what cells make wrong next to c reaches further cells as such terms, with
// c_k of the order of the cells' length to the power -k. A place that is wrong by delta is c_-1 = +-lambda delta c_0.

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "model/direction.hpp"

namespace steadyslide::numeric::variational {

/// Means of t over cells, in any unit. mean.size() + 1 == edges.size(), edges increasing.
struct Cells {
  std::span<const double> edges;
  std::span<const double> mean;
};

/// The cells of one side of c between two distances, neighbours gathered where they are short beside their distance: a
/// mean over near <= |y| <= far.
struct Bin {
  Side side;
  double near;
  double far;
  double mean;
  double weight;  ///< smooth, zero at the ends of the window
};

/// The distances of cells from c that a fit looks at.
struct Window {
  double from;
  double to;
};

/// The cells wholly within the window. Empty unless they are shorter than half their distance.
std::vector<Bin> gathered(const Cells& cells, double place, Side side, const Window& window);

struct LocalSeries {
  std::optional<double> exponent = std::nullopt;  ///< absent: the logarithm
  double left_factor = 1;
  double right_factor = 1;
  double s = 0;
  int poles = 0;
  int terms = 0;
  int remainder = -1;  ///< -1: none
};

struct SeriesFit {
  double amplitude = std::numeric_limits<double>::quiet_NaN();   ///< c_0
  double first_pole = std::numeric_limits<double>::quiet_NaN();  ///< c_-1
  double remainder = std::numeric_limits<double>::quiet_NaN();   ///< r_0
  double square = std::numeric_limits<double>::infinity();       ///< weighted sum of the squares left
  long freedom = 0;                                              ///< bins less coefficients
};

/// Rows are divided by |y|^scaling: with scaling = lambda errors are relative to the singular term. Bins that are no
/// more than the coefficients are not fitted.
SeriesFit fitted(std::span<const Bin> bins, const LocalSeries& series, double scaling);

}  // namespace steadyslide::numeric::variational
