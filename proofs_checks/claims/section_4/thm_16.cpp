#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim thm_16() {
  return beyond_calculation(
      "thm-16", {"its statement and proof are not in the text at hand; what theorem 1 needs of it is existence",
                 {"vi-discrete-existence", "vi-convergence-jump-up", "vi-convergence-jump-down", "rh-form"}});
}

}  // namespace steadyslide::proofs_checks
