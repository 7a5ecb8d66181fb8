#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim eq_10_derived() { return derived("eq-10-derived", decided_riemann_hilbert); }

}  // namespace steadyslide::proofs_checks
