#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim eq_04_derived() { return derived("eq-04-derived", decided_riemann_hilbert); }

}  // namespace steadyslide::proofs_checks
