#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim quartic_derived() { return derived("quartic-derived", decided_riemann_hilbert); }

}  // namespace steadyslide::proofs_checks
