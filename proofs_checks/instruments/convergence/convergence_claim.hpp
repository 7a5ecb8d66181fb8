#pragma once
// The claim that the cell solver converges to the Riemann-Hilbert solution. The claim's text names the problem in
// convergence_cases().

#include <string_view>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim convergence_claim(std::string_view id);

}  // namespace steadyslide::proofs_checks
