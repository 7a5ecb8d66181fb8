// The page's table of symbols with their meanings, made of the section "Notation" of docs/theory.md. The symbols of a
// formula are linked to it (report.js).

#include <fmt/format.h>

#include "app/html/mathml.hpp"
#include "app/report/sections.hpp"
#include "proofs_checks/proof/markdown.hpp"

namespace steadyslide::app {

std::string symbols_html(std::string_view markdown) {
  // A row has the cells symbol, meaning, type in the code, place in the paper, unit.
  HtmlRows rows;
  for (const std::string_view line : proofs_checks::parts_of(markdown, "\n")) {
    if (!line.starts_with("| ")) continue;
    const std::vector<std::string> cells = cells_of_row(line);
    if (cells.size() != 5 || cells.front() == "symbol") continue;
    const std::string symbol =
        fmt::format(R"(<span class="symbol" id="symbol-{}">{}</span>)", rows.size() + 1, escaped(cells[0]));
    rows.push_back({symbol, prose(cells[1]), escaped(cells[3]), escaped(cells[4])});
  }
  if (rows.empty()) return "";
  return block(
             "p",
             "<i>F</i> is a force, <i>L</i> a length, in whatever set of units. Press a formula of this page to see what its "
             "symbols mean, and to copy it as TeX; a passage that is copied has its formulas as TeX, too.") +
         folded(fmt::format("all {} symbols", rows.size()),
                table_element("Symbols", {"symbol", "meaning", "in the paper", "unit"}, rows, "Symbols."));
}

}  // namespace steadyslide::app
