#pragma once
// Proofs of the ledger as trees: what is concluded, and below it what it rests on, down to identities, signs, enclosures,
// classical theorems and other entries.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/terminal/output.hpp"
#include "proofs_checks/proof/proof.hpp"

namespace steadyslide::app {

/// Indented, each fact with what it says and by what it follows.
void write_proof(const proofs_checks::CheckedProof& proof, Output& output);

/// {"complete", "gap", "for", "assumes", "concludes", "steps": [{"fact", "says", "by", "words", "from", "html"}]}, "from" counting
/// the steps from 0, "html" saying the same with formulas typeset.
nlohmann::ordered_json proof_json(const proofs_checks::CheckedProof& proof);

/// The entries, or the theorems, that its steps name, each once, in their order.
std::vector<std::string> names_used(const proofs_checks::CheckedProof& proof, proofs_checks::ProofStep::Kind kind);

}  // namespace steadyslide::app
