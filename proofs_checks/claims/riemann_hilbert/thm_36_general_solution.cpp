#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim thm_36_general_solution() { return derived("thm-36-general-solution", decided_riemann_hilbert); }

}  // namespace steadyslide::proofs_checks
