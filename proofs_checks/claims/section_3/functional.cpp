// The functional phi of the displacement form, and the contact conditions as inequalities. [Bal16, (11)-(16)]

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/claims/section_3/functional_parts.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> functional_claims() {
  return {functional_claim(), contact_conditions_claim(), conjugate_functional_claim()};
}

}  // namespace steadyslide::proofs_checks
