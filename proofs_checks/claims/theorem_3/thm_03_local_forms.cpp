#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim thm_03_local_forms() {
  return derived("thm-03-local-forms", decided_local_forms,
                 {end_family("theorem-3", false, true), end_family("theorem-3", true, true)});
}

}  // namespace steadyslide::proofs_checks
