#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim tilted_punch_derived() { return derived("tilted-punch-derived", decided_riemann_hilbert); }

}  // namespace steadyslide::proofs_checks
