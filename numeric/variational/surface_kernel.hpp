#pragma once
// The kernel of the contact problem, on cells. A pressure p displaces the surface downwards by
//
//   -u/c = int k(x - x') p(x') dx' + int^x s p dx' + int j(x - x') f(x') p(x') dx',
//
//   k(x) = (N(x) - log|x|)/pi + a constant,   j(x) = -T(x)/pi,
//
// with N and T of numeric/layers/surface_correction.hpp, both 0 for the half-plane. f > 0 sliding towards +x, otherwise
// f < 0. No other file of this folder uses a formula for k or j. The folder assumes only these properties:
//
//   - They depend on x - x' only; k is even, j is odd. So equal cells have Toeplitz matrices, and their transforms are
//     the symbol of the preconditioner.
//   - For |x| <= 1, k + f j is not negative, so no entry of the operator on a support of length 1 is negative
//     (lemke.hpp). The constant takes care of it. It is part of the indenter's approach.
//   - Far from 0 they are smooth, so a few points are sufficient between zones (surface_inverse.hpp).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>

#include "numeric/layers/surface_correction.hpp"

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
  /// The half-plane.
  SurfaceKernel() = default;
  /// `unit` is the length 1 of this file in the unit of `body`; null: the half-plane. |f| is at most `friction`.
  SurfaceKernel(std::shared_ptr<const SurfaceCorrection<double>> body, double unit, double friction);
  bool is_half_plane() const { return !body_; }

  /// Returns the body's symbols over those of the half-plane at a wave number > 0 (surface_correction.hpp).
  std::pair<double, double> symbols(double wave_number) const {
    return body_ ? body_->symbols(wave_number / unit_) : std::pair(1.0, 1.0);
  }

  /// Returns k at a distance other than 0.
  double at(double distance) const;
  /// Returns the mean of k over two cells [a, b] and [c, d], as for mean_log(); of the half-plane only.
  double mean(double a, double b, double c, double d) const;
  /// Returns the mean effect of a pressure 1 on a cell of length h over the cell at a distance of `cells` cells.
  double mean_of_equal_cells(double h, std::size_t cells) const;
  /// Returns the effect of a pressure 1 on a cell of length h at `cells` lengths from the cell's centre.
  double from_equal_cell(double h, double cells) const;
  /// Returns the mean of k over a cell [left, right] for a point outside it; exact, or at large distances by an
  /// expansion.
  double mean_from_point(double left, double right, double x) const;
  /// The same for a point inside the cell, which divides its length into `before` and `behind`; of the half-plane only.
  double mean_within(double before, double behind, double length) const;

  /// Returns j at a distance x - x'.
  double coupling(double distance) const;
  /// Returns the mean effect of f p = 1 on a cell of length h over the cell that is `cells` cells further right.
  double coupling_of_equal_cells(double h, double cells) const;
  /// Returns the effect of f p = 1 on a cell of length h at `cells` lengths to the right of its centre.
  double coupling_from_equal_cell(double h, double cells) const;

  // For sums over many cells: pi times the effect of a cell at other places.
  /// Returns the slope of u/c at x outside the cell, for t = 1 and this f. For a shear traction 1 on the half-plane, f =
  /// 0, this is also the slope of the tangential displacement.
  double slope(double left, double right, double x, double f) const;
  /// Returns u/c at `to` minus u/c at `from`, without the integral of s p, for a pressure 1 on the cell.
  double rise(double left, double right, double from, double to, double f) const;

 private:
  /// Returns N and T, in this file's unit.
  double normal(double y) const { return body_->normal(unit_ * y); }
  double turning(double y) const { return body_->coupling(unit_ * y); }
  /// Returns |y|, or its distance from the period if this is shorter: k is the same there.
  double folded(double y) const { return std::min(std::abs(y), std::abs(period_ - std::abs(y))); }
  /// Returns the number of parts of a length h on which rules are exact, for distances in [from, to].
  double parts_of(double h, double from, double to) const;
  /// Returns the mean of a smooth function over a cell of length h around y; over two such cells at this distance.
  template <class F>
  double smooth_mean(double y, double h, const F& f) const;
  template <class F>
  double smooth_mean_of_cells(double y, double h, const F& f) const;

  std::shared_ptr<const SurfaceCorrection<double>> body_;
  double unit_ = 1;
  double constant_ = 0;  ///< pi times the constant in k
  double period_ = std::numeric_limits<double>::infinity();
};

}  // namespace steadyslide::numeric::variational
