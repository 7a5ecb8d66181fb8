#include "proofs_checks/instruments/convergence/convergence_claim.hpp"

namespace steadyslide::proofs_checks {

Claim vi_convergence_wedge_and_jump() { return convergence_claim("wedge-and-jump"); }

}  // namespace steadyslide::proofs_checks
