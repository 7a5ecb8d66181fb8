#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/claims/figures/figures.hpp"

namespace steadyslide::proofs_checks {

std::vector<Claim> paper_figure_claims() { return {figure_rear_loaded(), figure_shape(), figure_parabola()}; }

}  // namespace steadyslide::proofs_checks
