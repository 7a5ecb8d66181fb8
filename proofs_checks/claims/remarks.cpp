// The remarks of section 2. [Bal16, remarks 1, 2]

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> remark_claims() { return {}; }

}  // namespace steadyslide::proofs_checks
