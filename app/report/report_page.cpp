#include "app/report/report_page.hpp"

#include <fmt/format.h>

#include "app/embedded.hpp"
#include "app/report/sections.hpp"
#include "proofs_checks/proof/markdown.hpp"

namespace steadyslide::app {
namespace {

/// A part of the page with its own heading.
struct Section {
  std::string id;
  std::string title;
  std::string html;  ///< empty: the page has no such part
};

}  // namespace

std::string report_html(const VerifyResult& result, const Supplement& supplement) {
  std::string contents;
  std::string sections;
  int number = 0;
  const std::string_view symbols = proofs_checks::section_of(embedded::theory_md, "## Notation");
  for (const auto& [id, title, html] :
       {Section{"paper", "The paper, statement by statement", paper_html(result)},
        {"notes", "Reading notes", notes_html(result)},
        {"guide", "How to read the ledger", std::string(embedded::guide_html)},
        {"ledger", "The ledger", ledger_html(result)},
        {"rests", "What rests on what", rests_html(result)},
        {"figures", "Figures", figures_html(supplement)},
        {"tables", "Exponents", tables_html(supplement.tables)},
        {"mutants", "Faults put into the program", mutants_html(supplement.mutants)},
        {"symbols", "Symbols", symbols_html(symbols)},
        {"reproduce", "How to reproduce and to cite this", reproduce_html(result, supplement)},
        {"references", "References", references_list(embedded::references_md)}}) {
    if (html.empty()) continue;
    const std::string heading = id + "-heading", numbered = fmt::format("{} {}", ++number, title);
    contents += element("li", link(numbered, id));
    sections += block("section", "\n" + block("h2", numbered, {{"id", heading}}) + html,
                      {{"id", id}, {"aria-labelledby", heading}});
  }
  std::string page = fmt::format(fmt::runtime(embedded::report_html), fmt::arg("version", version),
                                 fmt::arg("style", embedded::report_css), fmt::arg("script", embedded::report_js),
                                 fmt::arg("front", front_html(result, supplement)), fmt::arg("contents", contents),
                                 fmt::arg("sections", sections));
  return with_numbers(with_numbers(std::move(page), figure_mark, "Figure"), table_mark, "Table");
}

}  // namespace steadyslide::app
