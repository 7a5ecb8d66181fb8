#pragma once
// Statements that proofs decide in balls: for section 3, for remark 1, for a published integral and for single contact
// problems.

#include "enclosure/number/ball.hpp"
#include "proofs_checks/proof/enclosures.hpp"

namespace steadyslide::proofs_checks {

/// The precision at which signs are decided.
inline constexpr enclosure::Bits sign_bits = 64;

/// Decides |arctan(s)/pi| < 1/2 for s in an interval, which may be unbounded.
Enclosure edge_powers();
/// Decides log 2 > 0.
Enclosure logarithm_of_two();
/// Decides -log d >= 0 for d in an interval within ]0, 1].
Enclosure logarithm_of_a_unit();
/// Decides 1 <= sin(pi eps)/(pi eps (1-eps)) <= 1 + eps for eps in an interval within [0, 0.6].
Enclosure triangle_amplitude();
/// Decides that the fourth derivative of cos(pi alpha) ((1+2 alpha)/(1-2 alpha))^alpha in s = tan(pi alpha) is at most
/// 4!/20.
Enclosure peak_of_parabola();
/// Decides that -pi sqrt(2)/3^{3/4} is in ]-1.949054259166748, -1.949054259166747[.
Enclosure galin_at_two();
/// Decide the solutions of three contact problems, with every sign.
Enclosure contact_over_notch();
Enclosure contact_of_two_wells();
Enclosure contact_of_bowl();

}  // namespace steadyslide::proofs_checks
