// The displacements of the surface under given tractions. [Bal16, (1)]

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> surface_displacement_claims() { return {}; }

}  // namespace steadyslide::proofs_checks
