#include "proofs_checks/instruments/convergence/convergence_claim.hpp"

namespace steadyslide::proofs_checks {

Claim vi_convergence_jump_up() { return convergence_claim("jump-up"); }

}  // namespace steadyslide::proofs_checks
