#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim thm_09_local_forms() { return derived("thm-09-local-forms", decided_local_forms); }

}  // namespace steadyslide::proofs_checks
