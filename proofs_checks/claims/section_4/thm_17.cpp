#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim thm_17() {
  return beyond_calculation(
      "thm-17",
      {"its statement and proof are not in the text at hand, and regularity for all profiles is no calculation",
       {"thm-02-local-forms", "thm-02-solved-wedge-and-jump", "thm-09-solved-wedge", "vi-convergence-wedge-and-jump"}});
}

}  // namespace steadyslide::proofs_checks
