// Problems I and I0, discretised one by one. [Bal16, section 3.2]

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/claims/section_3/dual_problem_parts.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> dual_problem_claims() {
  return {form_of_displacements_claim(), problem_i0_claim(), problem_i_claim(), linked_problems_claim(),
          homogeneous_friction_claim()};
}

}  // namespace steadyslide::proofs_checks
