#pragma once
// All claims, in their order: by place in the paper.

#include <span>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

/// Made at the first call, the same claims in the same order ever after.
const std::vector<Claim>& registry();

}  // namespace steadyslide::proofs_checks
