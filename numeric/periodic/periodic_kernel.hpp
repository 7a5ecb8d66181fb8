#pragma once
// The kernels of periodic contact without the half-plane's own. A pressure p >= 0 on one period L displaces the surface
// downwards by
//
//   -u/c = (1/pi) int p(x') [-log|x - x'| + N(x' - x)] dx' + int^x s p dx' + (1/pi) int +-f(x') p(x') T(x' - x) dx',
//
//   N(y) = log|y/(2 sin(pi y/L))|,   T(y) = gamma pi y/L,   |y| < L,
//
// up to a constant, with s = +-gamma f. -log|y| + N(y) is the sum over all periods, and T takes off the mean of s p, so
// that u is periodic. N is infinite at |y| = L, where the next period begins: N(y) = log|y| - log(L - |y|) + N(L - |y|).

#include "numeric/quadrature/jacobi_rule.hpp"

namespace steadyslide::numeric {

template <Real R>
class PeriodicKernel {
 public:
  PeriodicKernel(const R& period, const R& gamma);

  /// Returns N.
  R normal(const R& y) const;
  /// Returns N' = 1/y - (pi/L) cot(pi y/L), without cancellation.
  R normal_slope(const R& y) const;
  /// Returns T.
  R coupling(const R& y) const { return gamma_ * wave_number_ * y; }
  /// Returns T', which is constant.
  R coupling_slope() const { return gamma_ * wave_number_; }
  /// Returns the mean of N(x' - x) over x and x' in two cells of length h whose centres differ by y, |y| + h <= L and
  /// h <= L/4. The mean of T is T(y).
  R mean_of_cells(const R& y, const R& h) const;

 private:
  /// Returns the mean of f(y + v) over |v| < h with the weight 1 - |v|/h.
  template <class F>
  R mean(const R& y, const R& h, const F& f) const;
  R mean_of_logarithm(const R& y, const R& h) const;

  R period_;
  R wave_number_;  ///< pi/L
  R gamma_;
  UnitRule<R> rule_;  ///< for the weight y
};

}  // namespace steadyslide::numeric
