// The contact problem and what leaves it unchanged. [Bal16, (2), (3)]

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> problem_claims() { return {}; }

}  // namespace steadyslide::proofs_checks
