#pragma once
// What an examination brought back, piece by piece, as HTML.

#include <string>

#include "proofs_checks/kit/run.hpp"

namespace steadyslide::app {

/// All evidence of a report, one block for each kind, and the note on it. `reports` is the whole ledger: consequences
/// that are in it are linked.
std::string evidence_html(const proofs_checks::Report& report, std::span<const proofs_checks::Report> reports);

/// The controls, each with what refuted it or the fact that nothing did.
std::string controls_html(const proofs_checks::Report& report);

}  // namespace steadyslide::app
