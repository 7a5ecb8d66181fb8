#include "proofs_checks/instruments/convergence/convergence_claim.hpp"

namespace steadyslide::proofs_checks {

Claim vi_convergence_two_zones() { return convergence_claim("two-zones"); }

}  // namespace steadyslide::proofs_checks
