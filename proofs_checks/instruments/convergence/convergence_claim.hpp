#pragma once
// The claim that the solver on cells tends to the Riemann-Hilbert solution of one of the problems of
// convergence_cases(): vi-convergence-NAME.

#include <string_view>

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim convergence_claim(std::string_view name);

}  // namespace steadyslide::proofs_checks
