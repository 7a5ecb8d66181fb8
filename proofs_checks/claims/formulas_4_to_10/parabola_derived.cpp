#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim parabola_derived() { return derived("parabola-derived", decided_riemann_hilbert); }

}  // namespace steadyslide::proofs_checks
