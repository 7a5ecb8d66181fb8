#pragma once
// Galin's parabola psi/c = x^2/(2 R) with any number of friction jumps inside the contact, x measured from the vertex.
//
// Exponents p = (1/2 - alpha_0, alpha_0 - alpha_1, ..., 1/2 + alpha_m) at r = (a, c_1, ..., c_m, b):
//   sum p_j r_j = 0,   sum p_j r_j^2 = 2 P R/pi =: K,   t = -cos(pi alpha) |Y|/R.
// If the jumps inside are known, a square root solves both equations. Without a jump, a^2 = P R/(2 pi (1/4 - alpha^2))
// for the half-width [Bal16, section 2]. The contact grows with the load at both ends and reaches one jump after the
// other.

#include <vector>

#include "numeric/number/power.hpp"

namespace steadyslide::numeric {

template <Real R>
struct ParabolaZone {
  R left;             ///< a < 0, measured from the vertex
  R right;            ///< b > 0, measured from the vertex
  R error;            ///< estimated absolute error of both
  std::size_t first;  ///< the friction piece at a
  std::size_t last;   ///< the friction piece at b
};

/// Takes s for each friction piece, the jumps between them measured from the vertex, and K > 0.
template <Real R>
ParabolaZone<R> parabola_zone(const std::vector<Rational>& s, const std::vector<Rational>& jumps, const R& K);

}  // namespace steadyslide::numeric
