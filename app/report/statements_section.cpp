#include <algorithm>

#include "app/report/mathml.hpp"
#include "app/report/sections.hpp"
#include "proofs_checks/paper_statements.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

/// Links to the entries of this run, each with its verdict; empty if none was examined.
std::string entries(const checks::PaperStatement& statement, const VerifyResult& result) {
  std::string links;
  for (const std::string_view id : statement.claims) {
    const auto report = std::ranges::find(result.reports, id, [](const checks::Report& r) { return r.claim.id; });
    if (report == result.reports.end()) continue;
    const std::string_view verdict = name_of(report->verdict);
    const std::string text = element("a", escaped(id), {{"href", "#" + std::string(id)}}) + " " +
                             element("span", verdict, {{"class", "badge " + std::string(verdict)}});
    links += element("li", text);
  }
  return links.empty() ? links : element("ul", links, {{"class", "entries"}});
}

}  // namespace

Section statements_section(const VerifyResult& result) {
  Section section{"paper", "The paper, statement by statement", ""};
  std::vector<std::vector<std::string>> rows;
  for (const checks::PaperStatement& statement : checks::paper_statements()) {
    std::string links = entries(statement, result);
    if (links.empty()) continue;
    const std::string place = statement.place.empty() ? "beyond the paper" : std::string(statement.place);
    rows.push_back({prose(place), prose(statement.what), std::move(links)});
  }
  if (!rows.empty()) section.html = table_element(section.title, {"place", "what it says", "entries"}, rows);
  return section;
}

}  // namespace steadyslide::app
