#pragma once
// Y = z^S (1 + d_1/z + d_2/z^2 + ...) and 1/Y = z^-S (1 + c_1/z + ...), as far as the load, its moment and the
// polynomials of the profile ask for them. Where an Estimate is returned its error is what rounding may have done to it.

#include <vector>

#include "numeric/number/estimate.hpp"
#include "numeric/riemann_hilbert/signed_fundamental_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
class ExpansionAtInfinity {
 public:
  explicit ExpansionAtInfinity(const SignedFundamentalSolution<R>& y);

  /// d_i, from d_0 = 1.
  const std::vector<R>& series() const { return series_; }
  /// c_i, from c_0 = 1.
  const std::vector<R>& inverse_series() const { return inverse_series_; }

  /// Coefficients of [g/Y]_poly, at least one.
  std::vector<Estimate<R>> polynomial_part(const std::vector<R>& g) const;
  /// The coefficient of z^-1-j of (g + tilt)/Y.
  Estimate<R> moment(const std::vector<R>& g, const R& tilt, std::size_t j) const;

  /// [1/Y]_poly at x.
  R tilt_polynomial(const R& x) const;
  /// The coefficient of z^-1-j of 1/Y: what the tilt adds to the moments of u'/(c Y).
  R tilt_moment(std::size_t j) const;

 private:
  /// g times a coefficient of 1/Y.
  Estimate<R> term(const R& g, std::size_t i) const;

  int degree_;
  std::vector<R> series_;
  std::vector<R> inverse_series_;
  std::vector<R> sizes_;  ///< of what was added up for each of inverse_series_
};

}  // namespace steadyslide::numeric
