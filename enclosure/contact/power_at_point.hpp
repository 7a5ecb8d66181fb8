#pragma once
// Cauchy's integral of a power beside its point, -1 < a < 1 and 0 <= d <= L/2:
//
//   int_0^L y^a/(y + d) dy = L^a (E(d)/sinc(pi a) + k(a) - sum_{j>=1} (-d/L)^j/(j - a)),
//   E(d) = int_d^L (y/L)^a dy/y = (1 - (d/L)^a)/a, or log(L/d) for a = 0,     k(a) = 1/a - pi/sin(pi a), 0 for a = 0.
//
// Only E is not analytic at d = 0. For a small friction jump its two terms are as large as 1/a, but their difference is
// not. Balls for intervals of d stay narrow only if the difference is not computed.

#include "enclosure/number/ball.hpp"

namespace steadyslide::enclosure {

class PowerAtPoint {
 public:
  /// Takes a, which is exactly 0 if `is_zero`, and L > 0.
  PowerAtPoint(Ball a, bool is_zero, Ball length);

  /// Returns L^a/sinc(pi a), the factor of E.
  const Ball& factor() const { return factor_; }
  /// Returns the rest of the integral, which is analytic in d. Not finite if d is not small compared with L.
  Ball analytic_part(const Ball& d) const;
  /// Returns the constant part of E, 1/a or log L. The other part is a power of d, or -log d.
  Ball constant() const;

  /// Returns d^m E(d) for all d >= 0 in the ball; not finite if this is unbounded.
  Ball singular_part(const Ball& d, int m) const;
  /// Returns E(d), which is the minimum of E up to d.
  Ball at(const Ball& d) const;

 private:
  Ball a_;
  bool is_zero_;
  Ball length_;
  Ball scale_;  ///< L^a
  Ball factor_;
  Ball constant_;  ///< k(a)
};

}  // namespace steadyslide::enclosure
