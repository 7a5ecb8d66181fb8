#include "proofs_checks/claims/form_parts.hpp"

namespace steadyslide::proofs_checks {
std::vector<Claim> constant_friction_claims() { return {}; }
}  // namespace steadyslide::proofs_checks
