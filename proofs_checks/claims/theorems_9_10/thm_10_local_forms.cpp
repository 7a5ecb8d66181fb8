#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim thm_10_local_forms() { return derived("thm-10-local-forms", decided_local_forms); }

}  // namespace steadyslide::proofs_checks
