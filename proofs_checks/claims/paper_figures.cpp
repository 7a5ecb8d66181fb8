// What the figures of the paper show. [Bal16, figures 3-5]

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> paper_figure_claims() { return {}; }

}  // namespace steadyslide::proofs_checks
