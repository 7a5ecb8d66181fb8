#pragma once
// B_k on a panel as a polynomial. So an interval of places loses no digits where B_k is a small difference of large
// terms. Let y go from -1 to 1 along the panel, T_n be Chebyshev's polynomial, and y' lie outside. In
//
//   1/(y' - y) = (1 - T_n(y)/T_n(y'))/(y' - y) + (T_n(y)/T_n(y'))/(y' - y),
//
// the first term is a polynomial of degree n - 1 in y and the second one vanishes at the zeros of T_n. So the
// polynomial of degree n - 1 through the values of sum_l d_l/(x_l - x) at these zeros differs from this sum by
//
//   |sum_l d_l T_n(y)/T_n(y_l)/(x_l - x)| <= sum_l |d_l|/(delta T_n(1 + delta/a))
//
// if no x_l is closer than delta to the panel of half the length a: |T_n| <= 1 on the panel, and outside it grows:
// |T_n(y)| = cosh(n acosh |y|) > z^n/2, z = |y| + sqrt(y^2 - 1). All sums of B_k's rules are interpolated in this way,
// together with [(g_k + tilt)/Y]_poly - q/pi, whose degree is below n. The errors of the rules are added.

#include <optional>

#include "checker/traction_representation.hpp"

namespace steadyslide::checker {

class Interpolant {
 public:
  /// Returns B_k over `length` from the place `start`, to 2^-bits of its integrals with absolute values. Absent if a
  /// segment with another polynomial is closer than an eighth of the length.
  static std::optional<Interpolant> of(const TractionRepresentation& form, slong bits, std::size_t k,
                                       const SurfacePoint& start, const Ball& length);

  /// Returns a ball that contains all values on the panel.
  Ball range() const;
  /// Returns the coefficients of 1, y, y^2, ... of a polynomial whose distance from B_k is at most `rest`.
  std::vector<Ball> polynomial() const;
  const Ball& rest() const { return rest_; }
  /// Returns an upper bound of (1/pi) int_K cos(pi alpha) |g - g_k|/|Y| dx'/|x'-x| on the panel.
  const Ball& integrals() const { return integrals_; }

 private:
  std::vector<Ball> coefficients_;  ///< of T_0, T_1, ..., exact
  Ball rest_;
  Ball integrals_;
};

}  // namespace steadyslide::checker
