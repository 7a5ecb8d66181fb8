#pragma once
// The conditions F = 0 on the unknowns: log h of the free ends, the coefficients of q except the leading one, the tilt.
// With the expansion u'/c = Y (m_0/z + m_1/z^2 + ... + q/pi) at infinity:
//
//   the coefficient of z^-k in u'/c is 0 for 1 - S <= k < 1, and P/pi for k = 1         if S >= 0 (for S < 0 it is q's)
//   steps + int (g - g_k) + int Y B_k = 0 over each gap                    the profile's increment is the surface's
//   the coefficient of z^-2 is P load_at/pi                                with a free tilt
//
// The derivative needs no derivative of an integral: d(u'/c)/d e_f is Y times a rational function (Liouville),
//   d(u'/c)/d e_f = Y (rho_f/(z - e_f) + r),  rho_f = p_f B(e_f),  r = -p_f [q/(z - e_f)]_poly/pi,
//   d(u'/c)/d q_l = Y z^l/pi,  d(u'/c)/d tilt = 1 - Y [1/Y]_poly.

#include "checker/traction_representation.hpp"

namespace steadyslide::checker {

/// Returns int (g - g_k) over [from, to] in a segment, both measured from its left point; g is the segment's own slope.
Ball slope_difference(const Contact& contact, std::size_t segment, std::size_t k, const Ball& from, const Ball& to);
/// Returns the gap at a place outside the contact, starting from the end of contact at point `end`:
/// steps + int (g - g_k) + int Y B_k.
Ball gap_at(const TractionRepresentation& form, std::size_t end, const SurfacePoint& at);
/// Returns the longest segment between points j and i. In its middle a gap changes from one B_k to the other.
std::size_t longest_segment(const Contact& contact, std::size_t j, std::size_t i);

std::vector<Ball> conditions(const TractionRepresentation& form);
/// Returns a row for each condition, with a column for each unknown and then one for the load P/unit.
std::vector<std::vector<Ball>> jacobian(const TractionRepresentation& form);

}  // namespace steadyslide::checker
