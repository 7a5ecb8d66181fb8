// The functional phi of the displacement form, and the contact conditions as inequalities. [Bal16, (11)-(16)]

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> functional_claims() { return {}; }

}  // namespace steadyslide::proofs_checks
