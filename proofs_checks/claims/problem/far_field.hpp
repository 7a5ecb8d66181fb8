#pragma once
// What a contact does far away: stresses like 1/r, a displacement like log r. [Bal16, section 2]

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim infinite_energy_claim();

}  // namespace steadyslide::proofs_checks
