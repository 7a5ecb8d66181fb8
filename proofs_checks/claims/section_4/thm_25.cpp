#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim thm_25() {
  return beyond_calculation("thm-25",
                            {"a theorem on all Hilbert spaces, by an abstract argument",
                             {"lemma-04-functional", "sec-32-form-a", "prop-05-equivalence", "prop-06-problem-I0",
                              "prop-07-problem-I", "prop-07-problems-linked", "thm-08-homogeneous"}});
}

}  // namespace steadyslide::proofs_checks
