// The paper's statements with their verdicts, and the places where its text and the mathematics disagree.

#include <fmt/format.h>

#include <algorithm>

#include "app/html/mathml.hpp"
#include "app/report/sections.hpp"
#include "proofs_checks/statements/paper_statements.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

/// Returns links to entries. An entry whose verdict differs from that of the statement shows its verdict.
std::string links_to(const std::vector<std::string_view>& ids, const VerifyResult& result,
                     std::optional<checks::Verdict> statement) {
  std::string links;
  for (const std::string_view id : ids) {
    const checks::Report* report = report_on(id, result.reports);
    if (report == nullptr) continue;
    links += links.empty() ? "" : ", ";
    links += link(escaped(id), id);
    if (report->verdict != statement) links += " " + badge(report->verdict);
  }
  return links;
}

/// Returns the notes of a group as a table; empty if there is none.
std::string notes_table(const checks::NoteGroup& group, std::span<const checks::ReadingNote> notes) {
  const bool of_formulas = group.faults.size() > 1;
  HtmlRows rows;
  for (const checks::ReadingNote& note : notes) {
    if (std::ranges::find(group.faults, note.fault) == group.faults.end()) continue;
    std::string place = element("span", cited_prose(note.place), {{"id", "note-" + note.id}});
    if (!note.claim.empty()) place += "<br>" + link(escaped(note.claim), note.claim);
    rows.push_back({place, cited_prose(note.printed), cited_prose(note.derived)});
    if (of_formulas) rows.back().push_back(escaped(note.fault));
    rows.back().push_back(folded("why", block("p", cited_prose(note.evidence))));
  }
  if (rows.empty()) return "";
  std::vector<std::string> columns{"place", "printed", "derived"};
  if (of_formulas) columns.emplace_back("at fault");
  columns.emplace_back("evidence");
  return table_element("Reading notes", columns, rows, fmt::format("Reading notes: {}.", group.name));
}

}  // namespace

std::string paper_html(const VerifyResult& result) {
  HtmlRows rows, beyond;
  for (const checks::PaperStatement& statement : checks::paper_statements()) {
    const auto verdict = checks::verdict_of(statement, result.reports);
    const std::string said = links_to(statement.claims, result, verdict);
    const std::string instances = links_to(statement.instances, result, verdict);
    if (said.empty() && instances.empty()) continue;
    std::string entries = said;
    if (!instances.empty()) entries += (said.empty() ? "" : "; ") + ("instances: " + instances);
    std::string mark = "not examined as a whole", scope = prose(statement.scope);
    if (verdict) {
      // "proved" is a badge, ", restricted" stands behind it.
      mark = badge(*verdict) + std::string(standing(statement, *verdict).substr(name_of(*verdict).size()));
      if (*verdict == checks::Verdict::proved && !statement.restriction.empty())
        scope += "; restricted: " + prose(statement.restriction);
    }
    if (statement.place.empty()) {
      beyond.push_back({prose(statement.what), mark, entries});
    } else {
      rows.push_back({escaped(statement.place), prose(statement.what), mark, scope, entries});
    }
  }
  std::string html;
  if (!rows.empty()) {
    html +=
        block(
            "p",
            "What the paper says, in its order. A statement is as good as the weakest entry that says it or a part "
            "of it; the scope says for what, and how a statement is restricted. An entry shows its verdict where it has "
            "another one.") +
        table_element("The paper, statement by statement", {"place", "statement", "verdict", "scope", "entries"}, rows,
                      "The statements of the paper.");
  }
  if (!beyond.empty()) {
    html += table_element("Beyond the paper", {"statement", "verdict", "entries"}, beyond, "Beyond the paper.");
  }
  return html;
}

std::string faults_line(std::span<const checks::ReadingNote> notes) {
  const auto at = [&](std::string_view fault) { return std::ranges::count(notes, fault, &checks::ReadingNote::fault); };
  return fmt::format(
      "{} reading note{}: in formulas the print is at fault in {}, the extraction in {}, undecided between them {}; a "
      "hypothesis is missing in {}, the wording is at fault in {}. {}",
      notes.size(), notes.size() == 1 ? "" : "s", at("print"), at("extraction"), at("undecided"), at("hypothesis"),
      at("wording"), checks::printed_page);
}

std::string notes_html(const VerifyResult& result) {
  if (result.notes.empty() && result.notes_left_out == 0) return "";
  std::string html;
  if (!result.notes.empty()) html += block("p", element("strong", faults_line(result.notes)));
  html += block(
      "p",
      "Places where the text of the paper at hand and the mathematics disagree. That text was extracted from a "
      "PDF. A fault of the print is a slip in a formula of the paper itself, one of the extraction is not the paper's; "
      "where either may have made it, it is undecided. Missing hypotheses and wording are the paper's.");
  if (result.notes_left_out > 0) {
    html += block("p", fmt::format("Left out are {} notes on statements that were not examined in this run.",
                                   result.notes_left_out));
  }
  for (const checks::NoteGroup& group : checks::note_groups) html += notes_table(group, result.notes);
  return html;
}

}  // namespace steadyslide::app
