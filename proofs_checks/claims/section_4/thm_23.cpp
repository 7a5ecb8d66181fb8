#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim thm_23() {
  return beyond_calculation("thm-23", {"its statement and proof are not in the text at hand",
                                       {"energy-identity", "vi-energy-identity", "vi-definite-rising",
                                        "thm-01-uniqueness-on-cells", "vi-discrete-existence"}});
}

}  // namespace steadyslide::proofs_checks
