#pragma once
// The claims of remark 1 and remark 2, one file each. [Bal16, remarks 1, 2]

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim remark_front_rear();
Claim remark_incompressible();
Claim remark_vanishing_dundurs();
Claim remark_same_singularities();

}  // namespace steadyslide::proofs_checks
