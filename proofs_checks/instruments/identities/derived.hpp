#pragma once
// Claims whose equations the symbolic layer derives and decides. Its statements are the evidence, and each of their
// wrong variants is a control.

#include <string>
#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

/// Returns the claim with the families of statements that its text lists. The text alone gives the names of statements
/// and controls. They are compared with the symbolic layer when the claim is examined.
Claim derived(std::string_view id);

}  // namespace steadyslide::proofs_checks
