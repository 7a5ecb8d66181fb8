#pragma once
// B_k on a panel as a polynomial, so that an interval of places costs no digits where B_k is a small difference of large
// terms. Let y run from -1 to 1 along the panel, T_n be Chebyshev's polynomial, and y' lie outside. As
//
//   1/(y' - y) = (1 - T_n(y)/T_n(y'))/(y' - y) + (T_n(y)/T_n(y'))/(y' - y),
//
// whose first term is a polynomial of degree n - 1 in y and whose second one vanishes at the zeros of T_n, the polynomial
// of degree n - 1 through the values of sum_l d_l/(x_l - x) at these zeros differs from it by
//
//   |sum_l d_l T_n(y)/T_n(y_l)/(x_l - x)| <= sum_l |d_l|/(delta T_n(1 + delta/a))
//
// if no x_l is closer than delta to the panel of half the length a: |T_n| <= 1 on the panel and grows off it, where
// |T_n(y)| = cosh(n acosh |y|) > z^n/2, z = |y| + sqrt(y^2 - 1). So are all sums of B_k's rules interpolated, together
// with [(g_k + tilt)/Y]_poly - q/pi, whose degree is below n; what the rules err by comes on top.

#include <optional>

#include "checker/traction_representation.hpp"

namespace steadyslide::checker {

class Interpolant {
 public:
  /// B_k from the place `start` on over `length`, to 2^-bits of its integrals with absolute values. Nothing where a
  /// segment with another polynomial is closer than an eighth of the length.
  static std::optional<Interpolant> of(const TractionRepresentation& form, slong bits, std::size_t k,
                                       const Place& start, const Ball& length);

  /// A ball that contains all values on the panel.
  Ball range() const;
  /// Coefficients of 1, y, y^2, ... of a polynomial that is within `rest` of B_k.
  std::vector<Ball> polynomial() const;
  const Ball& rest() const { return rest_; }
  /// An upper bound of (1/pi) int_K cos(pi alpha) |g - g_k|/|Y| dx'/|x'-x| on the panel.
  const Ball& integrals() const { return integrals_; }

 private:
  std::vector<Ball> coefficients_;  ///< of T_0, T_1, ..., exact
  Ball rest_;
  Ball integrals_;
};

}  // namespace steadyslide::checker
