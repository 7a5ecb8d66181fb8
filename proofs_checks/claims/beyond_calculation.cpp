// What no calculation decides. [Bal16, theorems 1, 16, 17, 23-25]

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> beyond_calculation_claims() { return {}; }

}  // namespace steadyslide::proofs_checks
