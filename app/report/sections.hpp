#pragma once
// The parts of the page, and what they are made of: evidence as HTML, citations as links.

#include <span>

#include "app/report/html.hpp"
#include "app/report/report_page.hpp"

namespace steadyslide::app {

/// The paper's statements in its order, with the verdicts on them. Here and below: empty where there is nothing to tell.
std::string paper_html(const VerifyResult& result);
/// Every claim with its verdict, to be opened.
std::string ledger_html(const VerifyResult& result);
std::string notes_html(const VerifyResult& result);
std::string figures_html(const Supplement& supplement);
std::string tables_html(const std::vector<TextTable>& tables);
std::string mutants_html(const std::vector<Mutant>& mutants);
std::string reproduce_html(const VerifyResult& result);

/// The paragraphs of a Markdown text that begin with **[Key]**, as <dl>: emphasis and links, no more.
std::string references_list(std::string_view markdown);
/// Text with formulas, as prose() has it, with [Key, place] linked to the list.
std::string cited_prose(std::string_view text);

/// The report on a claim; null if there is none.
const proofs_checks::Report* report_on(std::string_view id, std::span<const proofs_checks::Report> reports);
std::string badge(proofs_checks::Verdict verdict);
/// All evidence of a report, one block for each kind, and the note on it. `reports` is the whole ledger: consequences
/// that are in it are linked.
std::string evidence_html(const proofs_checks::Report& report, std::span<const proofs_checks::Report> reports);
/// The controls, each with what refuted it or the fact that nothing did.
std::string controls_html(const proofs_checks::Report& report);

/// The options that repeat a run.
std::string options_again(const proofs_checks::Context& context);

/// The <svg> element alone. Several drawings share one page, so that every id and every reference to one begins with
/// `prefix`. The drawing's own title, which a browser would show as a hint, gives way to `title`. Scripts are left out.
std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view title);

}  // namespace steadyslide::app
