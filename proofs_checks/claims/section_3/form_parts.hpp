#pragma once
// The claims about the forms of section 3.1 that have files of their own.

#include <vector>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> sign_form_claims();
/// The form b under a constant friction coefficient.
std::vector<Claim> constant_friction_claims();

}  // namespace steadyslide::proofs_checks
