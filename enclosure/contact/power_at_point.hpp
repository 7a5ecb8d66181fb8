#pragma once
// Cauchy's integral of a power beside its point, -1 < a < 1 and 0 <= d <= L/2:
//
//   int_0^L y^a/(y + d) dy = L^a (E(d)/sinc(pi a) + k(a) - sum_{j>=1} (-d/L)^j/(j - a)),
//   E(d) = int_d^L (y/L)^a dy/y = (1 - (d/L)^a)/a, or log(L/d) for a = 0,     k(a) = 1/a - pi/sin(pi a), 0 for a = 0.
//
// E alone is not analytic at d = 0. Its two terms are as large as 1/a where friction hardly jumps, and their difference is not:
// balls for intervals of d keep their width only if it is not taken.

#include "enclosure/number/ball.hpp"

namespace steadyslide::enclosure {

class PowerAtPoint {
 public:
  /// a, which is 0 exactly if `is_zero`, and L > 0.
  PowerAtPoint(Ball a, bool is_zero, Ball length);

  /// L^a/sinc(pi a), E's factor.
  const Ball& factor() const { return factor_; }
  /// The rest of the integral, analytic in d. Not finite where d is no longer small beside L.
  Ball analytic_part(const Ball& d) const;
  /// The part of E that is constant, 1/a or log L. The other part is a power of d, or -log d.
  Ball constant() const;

  /// d^m E(d) for all d >= 0 in the ball; not finite where that is unbounded.
  Ball singular_part(const Ball& d, int m) const;
  /// E(d), the least up to d.
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
