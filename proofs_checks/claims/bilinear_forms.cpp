// The forms of the weak problem. [Bal16, section 3.1]

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> bilinear_form_claims() { return {}; }

}  // namespace steadyslide::proofs_checks
