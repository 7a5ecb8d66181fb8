#pragma once
// The power of the traction close to a singular point, from the operator alone: the p for which t = |x|^p solves
// A t = 0 close to 0. Principal values are computed by quadrature. No formula for an exponent, no arctangent and no
// cotangent is used, so that a formula for p can be checked against the result.
//
// For -1 < p < 0 the density y^p on the half-line y > 0 has H = m(p) at y = 1 and n(p) at y = -1,
//
//   m = (1/pi) PV int_0^oo y^p/(y-1) dy,   n = (1/pi) int_0^oo y^p/(y+1) dy;
//
// with y = e^tau, m + n = S(p+1) and m - n = S(p), S(p) = (1/pi) int_-oo^oo sinh(p tau)/sinh(tau) dtau. This integrand
// has no pole and is integrated by the trapezoidal rule. For 0 < p < 1 the kernel 1/(y-1) - 1/y replaces 1/(y-1), which
// omits a constant: m(p) = m(p-1), n(p) = -n(p-1).

#include "model/direction.hpp"
#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

/// The traction at an edge (unbounded) or at a free end (vanishing).
enum class EndTraction { unbounded, vanishing };

/// Returns the power p of t ~ d^p at an end of contact, -1 < p < 0 or 0 < p < 1. `contact` is the side of the contact.
template <Real R>
R end_power(Side contact, EndTraction end, const R& s);

/// The local form t ~ A_- |x|^p on the left and A_+ |x|^p on the right of a friction jump.
template <class R>
struct JumpPower {
  R power;  ///< -1/2 < p < 1/2; 0 if no other power solves the equation
  R ratio;  ///< A_-/A_+
};
template <Real R>
JumpPower<R> jump_power(const R& s_left, const R& s_right);

}  // namespace steadyslide::proofs_checks
