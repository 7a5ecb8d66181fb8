#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim thm_24() {
  return beyond_calculation("thm-24", {"its statement and proof are not in the text at hand",
                                       {"thm-02-local-forms", "thm-02-solved-wedge-and-jump", "thm-09-solved-wedge",
                                        "vi-convergence-jump-up", "vi-convergence-wedge"}});
}

}  // namespace steadyslide::proofs_checks
