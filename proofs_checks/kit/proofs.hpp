#pragma once
// The proofs of the ledger: checks the part "Proof" of a claim's text, and lets entries rest on each other.
//
// Controls of a proof: the proof with one step left out must have a gap, so that no step is idle. Each wrong variant of
// the identities and enclosures that decide its steps must be refuted.

#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/kit/claim.hpp"
#include "proofs_checks/proof/proof.hpp"

namespace steadyslide::proofs_checks {

/// Returns the checked proof of a claim, or null if it has none. A proof that rests on itself has a gap. Throws
/// std::logic_error if there is no such claim.
const CheckedProof* proof_of(std::string_view id);

/// Returns the claim with its proof as the first evidence, and with the proof's controls. Returns it unchanged if its
/// text has no proof.
Claim with_proof(Claim claim);

}  // namespace steadyslide::proofs_checks
