// Problems I and I0, discretised one by one. [Bal16, section 3.2]

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> dual_problem_claims() { return {}; }

}  // namespace steadyslide::proofs_checks
