#pragma once
// The signs that make a zero of the conditions a solution: t < 0 in the contact and gap > 0 outside. They are decided
// at every point of closed intervals, not sampled at places. With one ball for each unknown, they hold for the whole
// box.
//
// Contact, at distance d from a point c: t = eps cos(pi alpha) |Y| B_k. B_k is analytic up to an end, and across an
// anchor where the polynomial does not change. There it is sufficient to decide eps B < 0 on closed intervals, which
// includes theta > 0. If the polynomial changes by D = g_right - g_left,
//
//   B_k = R + S d^a,  S = D(x)/([s] eps cos(pi alpha) |Y_rest|),  a = -p         (beta = p, Y_rest = Y without d^p)
//   B_k = R + S log d,  S = D(x)/((1 + s^2) pi eps cos(pi alpha) |Y|)            (no jump of s)
//
// with R analytic in |d| < 2r, where r is half the distance to the next point. On 0 < d <= d1 = 2^-bits r the sum is
// bilinear in (R, S) and d^a or log d, which tends to 0 or infinity. So the values at the two ends decide. R comes from
// d1 with Cauchy's estimate |R'| <= M r/(r - d1)^2: J(d) = int_0^L y^a G(y)/(y + d) dy, of which B_k has +-eps cos(pi
// alpha)/pi times, is bounded on |d| = r by deforming the path (y on the semicircle over [0, L],
// |y + d| >= (|y| + r)/3):
//   |J| <= 3 sec(pi/4)^kappa max|D| int w/(u + r),
// and its singular part by |pi/sin(pi a) G(-d) d^a| or |G(-d) log d|, |G| <= max|D| prod 2^|p_j| d_j^(-p_j).
//
// Gap: it is 0 at a free end and a step at an edge. From there its increment is ((g - g_k) + Y B_k) dx, where k is the
// contact's slope. Powers of the distance to the end are integrated exactly. The gap is checked from both sides to the
// middle of the longest segment of a gap, and to the end of the support.

#include "checker/traction_representation.hpp"

namespace steadyslide::checker {

struct Signs {
  std::size_t in_contact = 0;  ///< intervals on which t < 0 was decided
  std::size_t in_gaps = 0;     ///< intervals on which gap > 0 was decided
  slong bits = 0;              ///< precision of the integrals
};

/// Proves the signs. Integrals start with few bits and use more if these do not decide: up to `bits`, and up to at
/// least 192. Throws Unproved with the place and the sign that is not decided.
Signs prove_signs(const ReducedProblem& problem, const Box& box, slong bits);

/// True if R + S phi < 0 for all phi from phi1 to 0, or to infinity of the same sign. R and S are intervals, so the
/// values at the two ends decide.
bool negative_between(const Ball& R, const Ball& S, const Ball& phi1, bool to_infinity);

}  // namespace steadyslide::checker
