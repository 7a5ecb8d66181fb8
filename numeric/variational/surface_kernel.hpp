#pragma once
// The kernel of the contact problem, on cells: a pressure p pushes the surface of the half-plane down by
//
//   -u/c = int k(x - x') p(x') dx',   k(x) = -log|x|/pi,
//
// without its friction. Nothing else in this folder knows k, and these properties are all that is assumed of it:
//
//   - It depends on x - x' alone and is even: equal cells have a Toeplitz matrix, whose transform is the preconditioner's symbol.
//   - It is not negative for |x| <= 1, so that no entry of the operator on a support of length 1 is (lemke.hpp).
//   - Far from 0 it is smooth, so that a zone sees another one at a few points (surface_inverse.hpp).

#include <cstddef>

namespace steadyslide::numeric::variational {

/// Exact means of the logarithm over two cells:
///
///   mean_log(a, b, c, d) = 1/((b-a)(d-c)) int_a^b int_c^d log|x - y| dy dx.
///
/// The cells are the same, meet, or are apart; none cuts into another. To about 1e-15, whatever the ratio of the lengths and of
/// the distance to them.
double mean_log(double a, double b, double c, double d);

/// The same over two cells of length 1 whose centres are k apart, to the last digits for every k.
double mean_log_of_unit_cells(std::size_t k);

class SurfaceKernel {
 public:
  /// k at a distance other than 0.
  double at(double distance) const;
  /// The mean of k over two cells [a, b] and [c, d], as for mean_log().
  double mean(double a, double b, double c, double d) const;
  /// The effect of a pressure 1 on a cell of length h: its mean over the cell that is `cells` further,
  double mean_of_equal_cells(double h, std::size_t cells) const;
  /// and its value `cells` lengths from the cell's centre.
  double from_equal_cell(double h, double cells) const;
  /// The mean of k over a cell [left, right] seen from a point outside it; exact, or from a distance by an expansion.
  double mean_from_point(double left, double right, double x) const;
  /// The same from a point within a cell, which divides its length into `before` and `behind`.
  double mean_within(double before, double behind, double length) const;

  // Of sums over many cells: pi times what a cell makes elsewhere.
  /// The slope of u/c at x outside the cell, under t = 1. Under a shear traction 1 also that of the tangential displacement.
  double slope(double left, double right, double x) const;
  /// By how much u/c at `to` exceeds that at `from`, under a pressure 1 on the cell.
  double rise(double left, double right, double from, double to) const;
};

}  // namespace steadyslide::numeric::variational
