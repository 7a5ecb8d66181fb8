#include <algorithm>

#include "app/report/mathml.hpp"
#include "app/report/sections.hpp"
#include "proofs_checks/statements/paper_statements.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

std::string verdict_link(const checks::Report& report) {
  const std::string_view verdict = name_of(report.verdict);
  const std::string mark = element("span", verdict, {{"class", "badge " + std::string(verdict)}});
  const std::string link = element("a", escaped(report.claim.id), {{"href", "#" + report.claim.id}});
  return element("span", link + " " + mark, {{"class", "verdict-link"}});
}

}  // namespace

Section paper_section(const VerifyResult& result) {
  Section section{"paper", "The paper, statement by statement", ""};
  std::vector<std::vector<std::string>> rows;
  for (const checks::PaperStatement& statement : checks::paper_statements()) {
    std::string links;
    for (const std::string_view id : statement.claims) {
      const auto found =
          std::ranges::find(result.reports, id, [](const auto& r) { return std::string_view(r.claim.id); });
      if (found != result.reports.end()) links += verdict_link(*found) + " ";
    }
    if (links.empty()) continue;
    const std::string place = statement.place.empty() ? "<em>beyond the paper</em>" : escaped(statement.place);
    rows.push_back({place, prose(statement.what), links});
  }
  if (rows.empty()) return section;
  section.html =
      element("p",
              "What the paper says, in its order, and the entries of the ledger that examine it. Where there "
              "are several, each looks at it in a way of its own.") +
      "\n" + table_element(section.title, {"place", "statement", "examined by"}, rows);
  return section;
}

}  // namespace steadyslide::app
