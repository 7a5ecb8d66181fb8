#pragma once
// The proofs of the ledger: what a claim's text has under "Proof", checked, and entries that rest on each other.
//
// Controls of a proof: each step left out leaves a gap, so that none is idle; and each wrong variant of what its steps
// decide is refuted.

#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/kit/claim.hpp"
#include "proofs_checks/proof/proof.hpp"

namespace steadyslide::proofs_checks {

/// Null where the claim has none. A proof that rests on itself has a gap. Throws std::logic_error if there is no such claim.
const CheckedProof* proof_of(std::string_view id);

/// With its proof in front of the evidence, and the proof's controls, where the text has one; else as it is.
Claim with_proof(Claim claim);

}  // namespace steadyslide::proofs_checks
