#include <fmt/format.h>

#include <algorithm>

#include "app/embedded.hpp"
#include "app/html/mathml.hpp"
#include "app/report/sections.hpp"
#include "proofs_checks/statements/paper_statements.hpp"
#include "symbolic/field/plain_formula.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

/// Returns the text that the filter searches. Formulas are as a person types them, not as they are typeset.
std::string searched(const checks::ClaimText& claim) {
  return symbolic::without_marks(claim.id + " " + claim.source + " " + claim.statement);
}

/// Returns the places of the paper that belong to the claim: its own, and those of the paper's statements that name it.
std::string places_of(const checks::ClaimText& claim) {
  std::string places = claim.source.substr(0, claim.source.find(':'));
  for (const checks::PaperStatement& statement : checks::paper_statements()) {
    const auto names = [&](const auto& ids) { return std::ranges::find(ids, claim.id) != ids.end(); };
    if (!statement.place.empty() && (names(statement.claims) || names(statement.instances)))
      places += fmt::format("; {}", statement.place);
  }
  return places;
}

std::string controls_badge(const checks::Report& report) {
  if (report.controls.empty()) return "no controls";
  return fmt::format("controls {}/{}", report.controls_refuted(), report.controls.size());
}

std::string summary(const checks::Report& report) {
  std::string badges = badge(report.verdict);
  if (report.beyond_calculation()) badges += " " + span("badge", "beyond calculation");
  const std::string head = element("h3", escaped(report.claim.id)) + badges + span("meta", controls_badge(report)) +
                           span("meta seconds", fmt::format("{:.2f} s", report.seconds));
  return block("summary", span("head", head) + span("source", prose(report.claim.source)) +
                              span("statement", prose(report.claim.statement)));
}

std::string part(std::string_view title, const std::string& html) {
  return html.empty() ? "" : block("h4", title) + html + "\n";
}

std::string paragraph(const std::string& html) { return html.empty() ? "" : element("p", cited(html)); }

std::string entry(const checks::Report& report, std::size_t order, const VerifyResult& result) {
  const checks::ClaimText& claim = report.claim;
  const std::string again = code("steadyslide verify --claim " + claim.id + options_again(result.context));
  const std::string body =
      part("Holds for", paragraph(prose(claim.hypotheses))) +
      part("How it follows", paragraph(lined(claim.derivation))) +
      part("Evidence", evidence_html(report, result.reports)) + controls_html(report) +
      block("p", again + span("link", " · " + link("link to this entry", claim.id)), {{"class", "again"}});
  return block("details", "\n" + summary(report) + block("div", "\n" + body, {{"class", "body"}}),
               {{"class", "claim"},
                {"id", claim.id},
                {"data-order", std::to_string(order)},
                {"data-verdict", name_of(report.verdict)},
                {"data-seconds", fmt::format("{:.6f}", report.seconds)},
                {"data-place", places_of(claim)},
                {"data-text", searched(claim)}});
}

/// Returns the form that filters, sorts and opens the entries. It needs JavaScript and is hidden without it.
std::string tools(const VerifyResult& result) {
  std::string boxes;
  for (const auto& [verdict, n] : count(result.reports)) {
    boxes += element(
        "label", fmt::format(R"(<input type="checkbox" name="verdict" value="{0}" checked> {0} ({1}))", verdict, n));
  }
  std::string places;
  for (const checks::PaperStatement& statement : checks::paper_statements()) {
    const std::string option = fmt::format(R"(<option value="{}">)", escaped_attribute(statement.place));
    if (!statement.place.empty() && places.find(option) == std::string::npos) places += option;
  }
  return fmt::format(fmt::runtime(embedded::tools_html), fmt::arg("verdicts", boxes), fmt::arg("places", places));
}

}  // namespace

std::string ledger_html(const VerifyResult& result) {
  std::string entries;
  std::size_t order = 0;
  for (const checks::Report& report : result.reports) entries += entry(report, order++, result);
  return entries.empty() ? "" : tools(result) + block("div", "\n" + entries, {{"id", "claims"}});
}

}  // namespace steadyslide::app
