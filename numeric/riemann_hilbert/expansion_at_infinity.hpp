#pragma once
// Y = z^S (1 + d_1/z + d_2/z^2 + ...) and 1/Y = z^-S (1 + c_1/z + ...), up to the order that the load, its moment and
// the polynomials of the profile need. The error of a returned Estimate is its rounding error.

#include <vector>

#include "numeric/number/estimate.hpp"
#include "numeric/riemann_hilbert/signed_fundamental_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
class ExpansionAtInfinity {
 public:
  explicit ExpansionAtInfinity(const SignedFundamentalSolution<R>& y);

  /// Returns d_i, from d_0 = 1 on.
  const std::vector<R>& series() const { return series_; }
  /// Returns c_i, from c_0 = 1 on.
  const std::vector<R>& inverse_series() const { return inverse_series_; }

  /// Returns the coefficients of [g/Y]_poly, at least one.
  std::vector<Estimate<R>> polynomial_part(const std::vector<R>& g) const;
  /// Returns the coefficient of z^-1-j of (g + tilt)/Y.
  Estimate<R> moment(const std::vector<R>& g, const R& tilt, std::size_t j) const;

  /// Returns [1/Y]_poly at x.
  R tilt_polynomial(const R& x) const;
  /// Returns the coefficient of z^-1-j of 1/Y, the effect of the tilt on the moments of u'/(c Y).
  R tilt_moment(std::size_t j) const;

 private:
  /// Returns g times a coefficient of 1/Y.
  Estimate<R> term(const R& g, std::size_t i) const;

  int degree_;
  std::vector<R> series_;
  std::vector<R> inverse_series_;
  std::vector<R> sizes_;  ///< sums of absolute values for each entry of inverse_series_
};

}  // namespace steadyslide::numeric
