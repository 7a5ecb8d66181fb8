#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim thm_36_exponents() { return derived("thm-36-exponents", decided_riemann_hilbert); }

}  // namespace steadyslide::proofs_checks
