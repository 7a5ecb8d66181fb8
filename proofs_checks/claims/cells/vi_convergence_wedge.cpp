#include "proofs_checks/instruments/convergence/convergence_claim.hpp"

namespace steadyslide::proofs_checks {

Claim vi_convergence_wedge() { return convergence_claim("wedge"); }

}  // namespace steadyslide::proofs_checks
