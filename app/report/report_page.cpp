#include "app/report/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/embedded.hpp"
#include "app/report/sections.hpp"

namespace steadyslide::app {
namespace {

/// A part of the page under a heading of its own.
struct Section {
  std::string id;
  std::string title;
  std::string html;  ///< empty: the part is left out
};

std::string tiles(const VerifyResult& result) {
  std::string html;
  for (const auto& [verdict, n] : count(result.reports)) {
    html += element("a", element("b", std::to_string(n)) + " " + element("span", verdict),
                    {{"href", "#ledger"}, {"class", fmt::format("tile {}", verdict)}});
  }
  return html;
}

std::string beyond(const VerifyResult& result) {
  const auto n = std::ranges::count_if(result.reports, &proofs_checks::Report::beyond_calculation);
  return n == 0 ? "" : fmt::format(" Undecided because beyond calculation: {}.", n);
}

}  // namespace

std::string report_html(const VerifyResult& result, const Supplement& supplement) {
  std::string contents;
  std::string sections;
  for (const auto& [id, title, html] : {Section{"guide", "How to read this", std::string(embedded::report_guide)},
                                        {"paper", "The paper, statement by statement", paper_html(result)},
                                        {"ledger", "The ledger", ledger_html(result)},
                                        {"notes", "Reading notes", notes_html(result)},
                                        {"figures", "Figures", figures_html(supplement)},
                                        {"tables", "Exponents", tables_html(supplement.tables)},
                                        {"mutants", "Faults put into the program", mutants_html(supplement.mutants)},
                                        {"reproduce", "How to reproduce this", reproduce_html(result)},
                                        {"references", "References", references_list(embedded::references_md)}}) {
    if (html.empty()) continue;
    const std::string heading = id + "-heading";
    contents += element("li", element("a", title, {{"href", "#" + id}}));
    sections += block("section", "\n" + block("h2", title, {{"id", heading}}) + html,
                      {{"id", id}, {"aria-labelledby", heading}});
  }
  return fmt::format(
      fmt::runtime(embedded::report_page), fmt::arg("version", version), fmt::arg("style", embedded::report_css),
      fmt::arg("print_style", embedded::report_print_css), fmt::arg("script", embedded::report_js),
      fmt::arg("digits", static_cast<int>(result.context.digits)), fmt::arg("seed", result.context.seed),
      fmt::arg("quick", result.context.quick ? " · quick: fewer parameters" : ""), fmt::arg("tiles", tiles(result)),
      fmt::arg("counts", counts_line(result.reports)), fmt::arg("controls", controls_line(result)),
      fmt::arg("beyond", beyond(result)), fmt::arg("contents", contents), fmt::arg("sections", sections));
}

}  // namespace steadyslide::app
