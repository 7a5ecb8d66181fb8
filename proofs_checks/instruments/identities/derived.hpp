#pragma once
// Claims whose equations the symbolic layer derives and decides: its statements as evidence, each wrong variant that it
// has as a control of its own.

#include <string>
#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

/// Of the families of statements that the claim's text lists. Names are known without deciding anything, and are compared
/// with the symbolic layer's when the claim is examined.
Claim derived(std::string_view id);

}  // namespace steadyslide::proofs_checks
