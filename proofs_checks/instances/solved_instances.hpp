#pragma once
// Instances that need a solved problem. Each list is computed at its first use.

#include "proofs_checks/proof/instances.hpp"

namespace steadyslide::proofs_checks {

/// Solutions of one problem for two loads that differ by a thousandth: the largest change of the traction inside the
/// contact per load, and the motions of the free ends, the largest on the left and the smallest on the right.
std::vector<Instance> growing_load();

/// Tractions next to a friction jump inside the contact, and next to a wedge under one friction value: at the distance
/// d, and the terms of the local form fitted at the distances 2 d and 4 d in front of the point.
std::vector<Instance> solved_rising_jumps();
std::vector<Instance> solved_falling_jumps();
std::vector<Instance> solved_wedges();

}  // namespace steadyslide::proofs_checks
