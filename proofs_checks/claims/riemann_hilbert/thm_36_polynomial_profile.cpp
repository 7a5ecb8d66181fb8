#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {

Claim thm_36_polynomial_profile() { return derived("thm-36-polynomial-profile", decided_riemann_hilbert); }

}  // namespace steadyslide::proofs_checks
