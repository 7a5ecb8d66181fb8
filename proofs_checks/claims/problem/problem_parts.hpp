#pragma once
// The claims about the contact problem that have files of their own.

#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

/// What leaves the problem unchanged, or changes its solution in a known way.
Claim complementarity_claim();

}  // namespace steadyslide::proofs_checks
