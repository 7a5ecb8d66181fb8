#pragma once
// The parts of the page, and the pieces that they share: evidence as HTML, citations as links, drawings.

#include <span>

#include "app/html/html.hpp"
#include "app/report/report_page.hpp"

namespace steadyslide::app {

/// Returns the beginning of the page: the paper, the main result, the counts, and how the page was made.
std::string front_html(const VerifyResult& result, const Supplement& supplement);
/// Returns the compiler, for example "GCC 12.2.0".
std::string compiler();
/// Returns the libraries that the program was compiled with: "GMP 6.2.1, MPFR 4.2.0, ...".
std::string libraries();

/// Returns the paper's statements in its order, with the verdicts on them. All functions ..._html() of a section return
/// an empty text if the section would have no content.
std::string paper_html(const VerifyResult& result);
/// Returns every claim with its verdict as an entry that a click opens.
std::string ledger_html(const VerifyResult& result);
std::string notes_html(const VerifyResult& result);
/// Returns the number of notes for each fault: "34 reading notes: in formulas the print is at fault in 8, ... The
/// printed page was not seen."
std::string faults_line(std::span<const proofs_checks::ReadingNote> notes);
/// Returns the words of the theorem that a step names, by "theorem NAME"; otherwise an empty text.
std::string theorem_words(std::string_view by);
/// Returns the graph of entries that rest on each other, and the classical theorems that proofs use.
std::string rests_html(const VerifyResult& result);
/// Returns the tables of the section "Notation" of docs/theory.md: each symbol with its meaning.
std::string symbols_html(std::string_view markdown);
std::string figures_html(const Supplement& supplement);
std::string tables_html(const std::vector<TextTable>& tables);
std::string mutants_html(const std::vector<Mutant>& mutants);
std::string reproduce_html(const VerifyResult& result, const Supplement& supplement);

/// Returns the paragraphs of a Markdown text that begin with **[Key]** as <dl>, and tables behind them. Of Markdown's
/// marks it knows emphasis and links alone.
std::string references_list(std::string_view markdown);
/// Returns the text of one reference of docs/references.md, without its table; empty if the key is unknown.
std::string reference_html(std::string_view key);
/// Returns HTML with each citation [Key, place] linked to the list of references.
std::string cited(const std::string& html);
/// Returns cited(prose(text)).
std::string cited_prose(std::string_view text);

/// Returns the report on a claim, or null if there is none.
const proofs_checks::Report* report_on(std::string_view id, std::span<const proofs_checks::Report> reports);
std::string badge(proofs_checks::Verdict verdict);
/// Returns all evidence of a report, one block for each kind, and the report's note. `reports` is the whole ledger:
/// consequences that it contains become links.
std::string evidence_html(const proofs_checks::Report& report, std::span<const proofs_checks::Report> reports);
/// Returns the controls: their number, and the list of them folded behind it. If one was not refuted, the list is open
/// and gives its details.
std::string controls_html(const proofs_checks::Report& report);

/// Returns the command line's options that repeat a run.
std::string options_again(const proofs_checks::Context& context);

/// Returns gnuplot's SVG without the parts that draw nothing: unused marks, empty groups and texts, default attributes,
/// blanks between elements, and the description, which the caption repeats. Shortens the paths of curves to what an eye
/// can see.
std::string slim_svg(std::string svg);
/// Returns the <svg> element alone, without scripts. Several drawings share one page, so that every id and every
/// reference to an id gets `prefix`. `title` replaces the drawing's own title, which a browser would show as a hint.
std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view title);

}  // namespace steadyslide::app
