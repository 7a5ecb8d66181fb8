#include "proofs_checks/instruments/convergence/convergence_claim.hpp"

namespace steadyslide::proofs_checks {

Claim vi_convergence_three_jumps() { return convergence_claim("three-jumps"); }

}  // namespace steadyslide::proofs_checks
