#pragma once
// The kernel of the contact problem, on cells. A pressure p displaces the surface of the half-plane downwards by
//
//   -u/c = int k(x - x') p(x') dx',   k(x) = -log|x|/pi,
//
// without friction. No other file of this folder uses a formula for k. The folder assumes only these properties:
//
//   - It depends on x - x' only and is even. So equal cells have a Toeplitz matrix, and its transform is the symbol of
//     the preconditioner.
//   - It is not negative for |x| <= 1, so no entry of the operator on a support of length 1 is negative (lemke.hpp).
//   - Far from 0 it is smooth, so a few points are sufficient between zones (surface_inverse.hpp).

#include <cstddef>

namespace steadyslide::numeric::variational {

/// Exact means of the logarithm over two cells:
///
///   mean_log(a, b, c, d) = 1/((b-a)(d-c)) int_a^b int_c^d log|x - y| dy dx.
///
/// The cells are equal, adjacent or separate; they do not overlap otherwise. The error is about 1e-15 for any ratio of
/// the lengths and of the distance.
double mean_log(double a, double b, double c, double d);

/// The same over two cells of length 1 whose centres have the distance k, to the last digits for every k.
double mean_log_of_unit_cells(std::size_t k);

class SurfaceKernel {
 public:
  /// Returns k at a distance other than 0.
  double at(double distance) const;
  /// Returns the mean of k over two cells [a, b] and [c, d], as for mean_log().
  double mean(double a, double b, double c, double d) const;
  /// Returns the mean effect of a pressure 1 on a cell of length h over the cell at a distance of `cells` cells.
  double mean_of_equal_cells(double h, std::size_t cells) const;
  /// Returns the effect of a pressure 1 on a cell of length h at `cells` lengths from the cell's centre.
  double from_equal_cell(double h, double cells) const;
  /// Returns the mean of k over a cell [left, right] for a point outside it; exact, or at large distances by an
  /// expansion.
  double mean_from_point(double left, double right, double x) const;
  /// The same for a point inside the cell, which divides its length into `before` and `behind`.
  double mean_within(double before, double behind, double length) const;

  // For sums over many cells: pi times the effect of a cell at other places.
  /// Returns the slope of u/c at x outside the cell, for t = 1. For a shear traction 1, this is also the slope of the
  /// tangential displacement.
  double slope(double left, double right, double x) const;
  /// Returns u/c at `to` minus u/c at `from`, for a pressure 1 on the cell.
  double rise(double left, double right, double from, double to) const;
};

}  // namespace steadyslide::numeric::variational
