#include "proofs_checks/claims/remarks/remarks.hpp"

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> remark_claims() {
  return {remark_front_rear(), remark_incompressible(), remark_vanishing_dundurs(), remark_same_singularities()};
}

}  // namespace steadyslide::proofs_checks
