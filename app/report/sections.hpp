#pragma once
// The parts of the page.

#include "app/report/html.hpp"
#include "app/report/references.hpp"
#include "app/report/report_page.hpp"

namespace steadyslide::app {

/// What the verdicts and the controls mean.
Section guide_section();
/// The paper's statements in its order, with the verdicts on them.
Section paper_section(const VerifyResult& result);
/// Every claim with its verdict, to be opened.
Section ledger_section(const VerifyResult& result);
Section notes_section(const VerifyResult& result);
Section figures_section(const Supplement& supplement);
Section tables_section(const std::vector<TextTable>& tables);
Section mutants_section(const std::vector<Mutant>& mutants);
Section reproduce_section(const VerifyResult& result);

/// The options that repeat a run.
std::string options_again(const proofs_checks::Context& context);

/// The <svg> element alone. Several drawings share one page, so that every id and every reference to one begins with
/// `prefix`. The drawing's own title, which a browser would show as a hint, gives way to `title`. Scripts are left out.
std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view title);

}  // namespace steadyslide::app
