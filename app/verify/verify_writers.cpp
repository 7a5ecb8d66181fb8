#include "app/verify/verify_writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "app/embedded.hpp"
#include "app/html/mathml.hpp"
#include "app/verify/proof_writers.hpp"
#include "proofs_checks/statements/paper_statements.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

std::string controls_text(const checks::Report& report) {
  return fmt::format("{}/{}", report.controls_refuted(), report.controls.size());
}

/// "beyond calculation: thm-16, thm-17"; empty if there is none.
std::string beyond_text(const VerifyResult& result) {
  std::string ids;
  for (const checks::Report& report : result.reports) {
    if (report.beyond_calculation()) ids += (ids.empty() ? "" : ", ") + report.claim.id;
  }
  return ids.empty() ? ids : "undecided because beyond calculation: " + ids;
}

/// Returns "1 claim" or "2 claims".
std::string numbered(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string left_out_text(const VerifyResult& result) {
  return fmt::format("{} left out: `steadyslide verify` without --claim shows all. {}",
                     numbered(result.notes_left_out, "reading note"), checks::printed_page);
}

std::string head_text(const VerifyResult& result) {
  return fmt::format("steadyslide {}: {} at {} digits, seed {}{}", version, numbered(result.reports.size(), "claim"),
                     static_cast<int>(result.context.digits), result.context.seed,
                     result.context.quick ? ", quick" : "");
}

/// Returns `head` and the text after it, in lines of 100 columns if the words allow it; further lines begin below the
/// text.
std::string wrapped(const std::string& head, std::string_view text) {
  constexpr std::size_t columns = 100;
  std::string result = head;
  std::size_t width = head.size();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (width > head.size() && width + 1 + end > columns) {
      result += "\n" + std::string(head.size(), ' ');
      width = head.size();
    } else if (width > head.size()) {
      result += ' ';
      ++width;
    }
    result += text.substr(0, end);
    width += end;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result + "\n";
}

/// Writes one line for each claim, and the findings for claims that are not settled. verify --list prints the
/// statements.
void write_verify_text(const VerifyResult& result, Output& output) {
  output.write(head_text(result) + "\n\n");
  Rows rows(Format::text, {"verdict", "controls", "seconds", "claim", "place"}, output);
  for (const checks::Report& report : result.reports) {
    rows.row({std::string(name_of(report.verdict)), controls_text(report), fmt::format("{:.2f}", report.seconds),
              report.claim.id, report.claim.source});
  }
  rows.end();
  for (const checks::Report& report : result.reports) {
    const checks::CheckedProof* proof = result.with_proofs ? report.proof() : nullptr;
    if (!proof) continue;
    output.write(fmt::format("\n{}\n  {}\n", report.claim.id, report.claim.statement));
    write_proof(*proof, output);
  }
  for (const checks::Report& report : result.reports) {
    const bool settled = report.verdict == checks::Verdict::proved || report.verdict == checks::Verdict::supported;
    if ((settled || report.beyond_calculation()) && report.note.empty()) continue;
    output.write(fmt::format("\n{} {}\n", report.claim.id, name_of(report.verdict)));
    for (const checks::Evidence& evidence : report.evidence) {
      output.write(fmt::format("  {}: {}\n", kind_of(evidence), describe(evidence)));
    }
    if (!report.note.empty()) output.write(fmt::format("  {}\n", report.note));
  }
  output.write("\n" + counts_line(result.reports) + "\n");
  if (std::ranges::any_of(result.reports, &checks::Report::proof)) {
    output.write("rules of the proofs: " + checks::rules_line(result.reports) + "\n");
  }
  if (const std::string line = checks::statements_line(result.reports); !line.empty()) {
    output.write("the paper's statements: " + line + "\n");
  }
  if (const std::string beyond = beyond_text(result); !beyond.empty()) output.write(beyond + "\n");
  if (result.notes_left_out > 0) output.write("\n" + left_out_text(result) + "\n");
  if (result.notes.empty()) return;
  output.write(fmt::format("\n{}: places where the text at hand and the mathematics disagree. {}\n",
                           numbered(result.notes.size(), "reading note"), checks::printed_page));
  for (const checks::ReadingNote& note : result.notes) {
    output.write(fmt::format("\n{}, {}\n", note.id, note.place));
    output.write(wrapped("  printed   ", note.printed));
    output.write(wrapped("  derived   ", note.derived));
    output.write(wrapped("  evidence  ", note.evidence));
  }
}

/// A text for a cell of a Markdown table.
std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("|*_<`").find(c) != std::string_view::npos) result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

void write_verify_markdown(const VerifyResult& result, Output& output) {
  output.write(fmt::format("# Verification\n\n{}: {}.\n\n", head_text(result), counts_line(result.reports)));
  Rows rows(Format::markdown, {"claim", "source", "statement", "hypotheses", "verdict", "controls", "evidence"},
            output);
  for (const checks::Report& report : result.reports) {
    std::string evidence;
    for (const checks::Evidence& e : report.evidence) {
      evidence += fmt::format("{}{}: {}", evidence.empty() ? "" : "<br>", kind_of(e), cell(describe(e)));
    }
    if (!report.note.empty()) evidence += (evidence.empty() ? "" : "<br>") + cell(report.note);
    rows.row({cell(report.claim.id), cell(report.claim.source), cell(report.claim.statement),
              cell(report.claim.hypotheses), std::string(name_of(report.verdict)), controls_text(report), evidence});
  }
  rows.end();
  if (result.notes_left_out > 0) output.write("\n" + left_out_text(result) + "\n");
  if (result.notes.empty()) return;
  output.write(fmt::format("\n## Reading notes\n\n{}. {}\n\n", numbered(result.notes.size(), "reading note"),
                           checks::printed_page));
  Rows notes(Format::markdown, {"note", "place", "printed", "derived", "evidence"}, output);
  for (const checks::ReadingNote& note : result.notes) {
    notes.row({cell(note.id), cell(note.place), cell(note.printed), cell(note.derived), cell(note.evidence)});
  }
  notes.end();
}

using Json = nlohmann::ordered_json;

/// Adds the texts of `keys` as HTML, with formulas typeset.
Json typeset(Json json, std::initializer_list<const char*> keys) {
  for (const char* key : keys) json["html"][key] = prose(json[key].get<std::string>());
  return json;
}

Json claim_json(const checks::ClaimText& claim) {
  return typeset({{"id", claim.id},
                  {"source", claim.source},
                  {"statement", claim.statement},
                  {"hypotheses", claim.hypotheses},
                  {"derivation", claim.derivation}},
                 {"source", "statement", "hypotheses", "derivation"});
}

Json report_json(const checks::Report& report) {
  Json json = claim_json(report.claim);
  json["verdict"] = name_of(report.verdict);
  json["evidence"] = Json::array();
  for (const checks::Evidence& evidence : report.evidence) {
    json["evidence"].push_back({{"kind", kind_of(evidence)}, {"detail", describe(evidence)}});
  }
  if (!report.note.empty()) json["evidence"].push_back({{"kind", "note"}, {"detail", report.note}});
  if (const checks::CheckedProof* proof = report.proof()) {
    json["proof"] = proof_json(*proof);
    json["rests_on"] = names_used(*proof, checks::ProofStep::Kind::entry);
  }
  json["controls"] = {{"total", report.controls.size()}, {"refuted", report.controls_refuted()}};
  json["seconds"] = std::round(report.seconds * 1000) / 1000;
  return json;
}

/// Returns the number of rules in words on which the proofs of a statement's claims rest.
std::size_t rules_in_words(const checks::PaperStatement& statement, std::span<const checks::Report> reports) {
  std::vector<checks::Report> own;
  std::ranges::copy_if(reports, std::back_inserter(own), [&](const checks::Report& report) {
    return std::ranges::count(statement.claims, report.claim.id) > 0;
  });
  return checks::rules_of(own).in_words.size();
}

void write_verify_json(const VerifyResult& result, Output& output) {
  Json json;
  json["schema"] = 1;
  json["version"] = version;
  json["commit"] = commit();
  json["digits"] = static_cast<int>(result.context.digits);
  json["seed"] = result.context.seed;
  for (const auto& [verdict, n] : count(result.reports)) json["counts"][std::string(verdict)] = n;
  const checks::ProofRules rules = checks::rules_of(result.reports);
  json["rules"] = {{"run", rules.run}, {"in_words", rules.in_words}};
  json["claims"] = Json::array();
  for (const checks::Report& report : result.reports) json["claims"].push_back(report_json(report));
  for (const auto& [standing, n] : checks::statement_counts(result.reports)) json["statement_counts"][standing] = n;
  json["statements"] = Json::array();
  for (const checks::PaperStatement& statement : checks::paper_statements()) {
    const auto verdict = checks::verdict_of(statement, result.reports);
    if (!verdict) continue;
    json["statements"].push_back(typeset({{"place", statement.place},
                                          {"statement", statement.what},
                                          {"verdict", name_of(*verdict)},
                                          {"standing", standing(statement, *verdict)},
                                          {"scope", statement.scope},
                                          {"restriction", statement.restriction},
                                          {"entries", statement.claims},
                                          {"instances", statement.instances},
                                          {"rules_in_words", rules_in_words(statement, result.reports)}},
                                         {"statement", "scope", "restriction"}));
  }
  json["reading_notes"] = Json::array();
  for (const checks::ReadingNote& note : result.notes) {
    json["reading_notes"].push_back(typeset({{"id", note.id},
                                             {"place", note.place},
                                             {"claim", note.claim},
                                             {"printed", note.printed},
                                             {"derived", note.derived},
                                             {"fault", note.fault},
                                             {"evidence", note.evidence}},
                                            {"place", "printed", "derived", "evidence"}));
  }
  json["reading_notes_left_out"] = result.notes_left_out;
  output.write(json.dump(2) + "\n");
}

void write_claims_json(std::span<const checks::Claim> claims, Output& output) {
  Json json;
  json["schema"] = 1;
  json["version"] = version;
  json["claims"] = Json::array();
  for (const checks::Claim& claim : claims) {
    json["claims"].push_back(claim_json(claim));
    json["claims"].back()["group"] = claim.group;
  }
  output.write(json.dump(2) + "\n");
}

}  // namespace

void write_verify(Format format, const VerifyResult& result, Output& output) {
  switch (format) {
    case Format::json: write_verify_json(result, output); break;
    case Format::markdown: write_verify_markdown(result, output); break;
    default: write_verify_text(result, output); break;
  }
}

void write_claims(Format format, std::span<const checks::Claim> claims, Output& output) {
  if (format == Format::json) return write_claims_json(claims, output);
  if (format == Format::text) {
    for (const checks::Claim& claim : claims) {
      output.write(fmt::format("{}\n  {}\n  {}\n  for {}\n  group {}\n\n", claim.id, claim.source, claim.statement,
                               claim.hypotheses, claim.group));
    }
    return;
  }
  Rows rows(format, {"claim", "source", "statement", "hypotheses"}, output);
  for (const checks::Claim& claim : claims) {
    rows.row({cell(claim.id), cell(claim.source), cell(claim.statement), cell(claim.hypotheses)});
  }
  rows.end();
}

std::string controls_line(const VerifyResult& result) {
  std::size_t total = 0;
  std::size_t refuted = 0;
  for (const checks::Report& report : result.reports) {
    total += report.controls.size();
    refuted += report.controls_refuted();
  }
  return fmt::format("{} of {} controls refuted", refuted, total);
}

void leave_out_other_notes(VerifyResult& result) {
  const auto is_other = [&](const checks::ReadingNote& note) {
    return std::ranges::none_of(result.reports, [&](const checks::Report& r) { return r.claim.id == note.claim; });
  };
  result.notes_left_out += std::erase_if(result.notes, is_other);
}

ExitCode exit_code_of(std::span<const checks::Report> reports) {
  return checks::settled(reports) ? ExitCode::done : ExitCode::refuted;
}

}  // namespace steadyslide::app
