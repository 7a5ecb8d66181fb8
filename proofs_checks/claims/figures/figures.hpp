#pragma once
// What figures 3 to 5 of the paper show, one claim and one file each. [Bal16, section 2]

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim figure_rear_loaded();
Claim figure_shape();
Claim figure_parabola();

}  // namespace steadyslide::proofs_checks
