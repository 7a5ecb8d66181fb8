#pragma once
// The claims on phi and on the contact conditions, one source file each.

#include "proofs_checks/kit/claim.hpp"

namespace steadyslide::proofs_checks {

Claim functional_claim();            ///< lemma-04-functional
Claim contact_conditions_claim();    ///< prop-05-equivalence
Claim conjugate_functional_claim();  ///< eq-16-conjugate

}  // namespace steadyslide::proofs_checks
