#pragma once
// The claim that the solver on cells tends to the Riemann-Hilbert solution of the problem of convergence_cases() that
// its text names.

#include <string_view>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim convergence_claim(std::string_view id);

}  // namespace steadyslide::proofs_checks
