#include "proofs_checks/instruments/convergence/convergence_claim.hpp"

namespace steadyslide::proofs_checks {

Claim vi_convergence_step() { return convergence_claim("step"); }

}  // namespace steadyslide::proofs_checks
