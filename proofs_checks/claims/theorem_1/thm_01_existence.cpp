#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim thm_01_existence() {
  return beyond_calculation("thm-01-existence",
                            {"existence for all data in a space of measures: a limit of approximations by compactness, "
                             "which examples do not replace",
                             {"vi-discrete-existence", "rh-form", "rh-count", "vi-convergence-jump-up",
                              "vi-convergence-jump-down", "vi-convergence-three-jumps", "thm-01-uniqueness-on-cells"}});
}

}  // namespace steadyslide::proofs_checks
