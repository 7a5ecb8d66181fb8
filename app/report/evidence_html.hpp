#pragma once
// What an examination brought back, piece by piece, as HTML.

#include <span>
#include <string>
#include <string_view>

#include "proofs_checks/kit/run.hpp"

namespace steadyslide::app {

/// The report on a claim; null if there is none.
const proofs_checks::Report* report_on(std::string_view id, std::span<const proofs_checks::Report> reports);

std::string badge(proofs_checks::Verdict verdict);

/// All evidence of a report, one block for each kind, and the note on it. `reports` is the whole ledger: consequences
/// that are in it are linked.
std::string evidence_html(const proofs_checks::Report& report, std::span<const proofs_checks::Report> reports);

/// The controls, each with what refuted it or the fact that nothing did.
std::string controls_html(const proofs_checks::Report& report);

}  // namespace steadyslide::app
