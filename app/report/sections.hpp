#pragma once
// The parts of the page, and what they are made of: evidence as HTML, citations as links.

#include <span>

#include "app/html/html.hpp"
#include "app/report/report_page.hpp"

namespace steadyslide::app {

/// What the page opens with.
std::string front_html(const VerifyResult& result, const Supplement& supplement);
/// "GCC 12.2.0", and "GMP 6.2.1, MPFR 4.2.0, ...": what the program was compiled with; the commit it was built from, empty
/// where that is not known.
std::string compiler();
std::string libraries();
std::string commit();

/// The paper's statements in its order, with the verdicts on them. Here and below: empty where there is nothing to tell.
std::string paper_html(const VerifyResult& result);
/// Every claim with its verdict, to be opened.
std::string ledger_html(const VerifyResult& result);
std::string notes_html(const VerifyResult& result);
/// "34 reading notes: in formulas the print is at fault in 8, ... The printed page was not seen."
std::string faults_line(std::span<const proofs_checks::ReadingNote> notes);
/// The graph of entries that rest on each other, and the classical theorems used.
std::string rests_html(const VerifyResult& result);
/// The tables of the section "Notation" of docs/theory.md: each symbol with its meaning.
std::string symbols_html(std::string_view markdown);
std::string figures_html(const Supplement& supplement);
std::string tables_html(const std::vector<TextTable>& tables);
std::string mutants_html(const std::vector<Mutant>& mutants);
std::string reproduce_html(const VerifyResult& result);

/// The paragraphs of a Markdown text that begin with **[Key]**, as <dl>: emphasis and links, no more.
std::string references_list(std::string_view markdown);
/// The text on one of them.
std::string reference_html(std::string_view key);
/// Text with formulas, as prose() has it, with [Key, place] linked to the list.
std::string cited_prose(std::string_view text);

/// The report on a claim; null if there is none.
const proofs_checks::Report* report_on(std::string_view id, std::span<const proofs_checks::Report> reports);
std::string badge(proofs_checks::Verdict verdict);
/// All evidence of a report, one block for each kind, and the note on it. `reports` is the whole ledger: consequences
/// that are in it are linked.
std::string evidence_html(const proofs_checks::Report& report, std::span<const proofs_checks::Report> reports);
/// The controls: their number, and behind it each with what refuted it; open where nothing refuted one.
std::string controls_html(const proofs_checks::Report& report);

/// The options that repeat a run.
std::string options_again(const proofs_checks::Context& context);

/// gnuplot's SVG without what nothing is drawn by: marks that no curve has, empty groups and texts, defaults, the blanks between
/// elements, the description that the caption repeats.
std::string slim_svg(std::string svg);
/// The <svg> element alone. Several drawings share one page, so that every id and every reference to one begins with
/// `prefix`. The drawing's own title, which a browser would show as a hint, gives way to `title`. Scripts are left out.
std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view title);

}  // namespace steadyslide::app
