#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim eq_05_07_derived() { return derived("eq-05-07-derived", decided_riemann_hilbert); }

}  // namespace steadyslide::proofs_checks
