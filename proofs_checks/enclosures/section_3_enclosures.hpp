#pragma once
// What proofs decide in balls.

#include "enclosure/number/ball.hpp"
#include "proofs_checks/proof/enclosures.hpp"

namespace steadyslide::proofs_checks {

/// What signs are decided at.
inline constexpr enclosure::Bits sign_bits = 64;

/// |arctan(s)/pi| < 1/2 for s in an interval, which may be unbounded.
Enclosure edge_powers();
/// log 2 > 0.
Enclosure logarithm_of_two();
/// -log d >= 0 for d in an interval within ]0, 1].
Enclosure logarithm_of_a_unit();
/// 1 <= sin(pi eps)/(pi eps (1-eps)) <= 1 + eps for eps in an interval within [0, 0.6].
Enclosure triangle_amplitude();

}  // namespace steadyslide::proofs_checks
