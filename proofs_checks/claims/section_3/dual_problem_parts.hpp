#pragma once
// The claims on problems I and I0, one source file each.

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim form_of_displacements_claim();  ///< sec-32-form-a
Claim problem_i0_claim();             ///< prop-06-problem-I0
Claim problem_i_claim();              ///< prop-07-problem-I
Claim linked_problems_claim();        ///< prop-07-problems-linked
Claim homogeneous_friction_claim();   ///< thm-08-homogeneous

}  // namespace steadyslide::proofs_checks
