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

/// The claim, proved by the statements with these ids, as `argument` says; each of their wrong variants is a control
/// more. What the claim itself compares stands behind.
Claim proved_by(const std::vector<std::string>& ids, std::string argument, Claim claim);

}  // namespace steadyslide::proofs_checks
