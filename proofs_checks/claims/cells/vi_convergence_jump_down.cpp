#include "proofs_checks/instruments/convergence/convergence_claim.hpp"

namespace steadyslide::proofs_checks {

Claim vi_convergence_jump_down() { return convergence_claim("jump-down"); }

}  // namespace steadyslide::proofs_checks
