// The sentences after theorem 2, and the conditions at a step. [Bal16, theorems 2, 3]

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> words_claims() { return {}; }

}  // namespace steadyslide::proofs_checks
