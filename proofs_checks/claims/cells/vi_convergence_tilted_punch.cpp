#include "proofs_checks/instruments/convergence/convergence_claim.hpp"

namespace steadyslide::proofs_checks {

Claim vi_convergence_tilted_punch() { return convergence_claim("tilted-punch"); }

}  // namespace steadyslide::proofs_checks
