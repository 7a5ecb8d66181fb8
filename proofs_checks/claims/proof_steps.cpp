// The steps of the proofs of theorems 9 and 10. [Bal16]

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> proof_step_claims() { return {}; }

}  // namespace steadyslide::proofs_checks
