#pragma once
// Proofs of the ledger as trees: a conclusion, and below it the facts on which it rests, down to identities, signs,
// enclosures, classical theorems and other entries.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/terminal/output.hpp"
#include "proofs_checks/proof/proof.hpp"

namespace steadyslide::app {

/// Writes the proof indented, each fact with its text and its reason.
void write_proof(const proofs_checks::CheckedProof& proof, Output& output);

/// {"complete", "gap", "for", "assumes", "concludes", "steps": [{"fact", "says", "by", "words", "from", "html"}]},
/// "from" the numbers of steps, from 0, "html" the same text with formulas typeset.
nlohmann::ordered_json proof_json(const proofs_checks::CheckedProof& proof);

/// Returns the entries, or the theorems, that its steps name, each once, in their order.
std::vector<std::string> names_used(const proofs_checks::CheckedProof& proof, proofs_checks::ProofStep::Kind kind);

}  // namespace steadyslide::app
