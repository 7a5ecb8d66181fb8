// What an examination brought back, piece by piece, as HTML.

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/report/mathml.hpp"
#include "app/report/sections.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

template <class Kind>
std::vector<const Kind*> all_of(const checks::Report& report) {
  std::vector<const Kind*> found;
  for (const checks::Evidence& evidence : report.evidence) {
    if (const Kind* piece = std::get_if<Kind>(&evidence)) found.push_back(piece);
  }
  return found;
}

std::string heading(std::string_view text) { return block("h5", text); }

std::string paragraph(std::string_view text) { return text.empty() ? "" : block("p", prose(text)); }

/// 3.1e-52 with a power of ten; what is no number as it is.
std::string number(const std::string& text) {
  const bool is_number = text.find_first_not_of("0123456789.e+-") == std::string::npos;
  return (is_number ? mathml(text) : std::nullopt).value_or(escaped(text));
}

std::string list(const std::vector<std::string>& items, const std::string& title = "") {
  if (items.empty()) return "";
  std::string html;
  for (const std::string& item : items) html += block("li", item);
  return title + block("ul", "\n" + html);
}

/// Said once, however many pieces of evidence say it.
template <class Kind>
std::string details(const std::vector<const Kind*>& pieces) {
  std::vector<std::string> seen;
  for (const Kind* piece : pieces) {
    if (std::ranges::find(seen, piece->detail) == seen.end()) seen.push_back(piece->detail);
  }
  std::string html;
  for (const std::string& detail : seen) html += paragraph(detail);
  return html;
}

/// As a list, indented by how far below what is concluded a fact stands.
std::string proof_html(const checks::Report& report) {
  const checks::CheckedProof* proof = report.proof();
  if (!proof) return "";
  std::string html = heading(proof->complete() ? "Proof" : "A proof with a gap");
  if (!proof->text.parameters.empty())
    html += block("p", "For " + element("code", escaped(text_of(proof->text.parameters))) + ".");
  std::string items;
  for (const auto& [at, depth, again] : tree_of(*proof)) {
    const checks::ProofNode& node = proof->nodes[at];
    std::string item = element("code", escaped(text_of(node.fact))) + " " +
                       element("span", escaped(node.by) + (again ? ", see above" : ""), {{"class", "by"}});
    if (!again) {
      item += element("span", prose(checks::theory().sentence(node.fact)), {{"class", "says"}});
      for (const std::string& words : node.words) item += element("span", prose(words), {{"class", "words"}});
    }
    items += block("li", item, {{"style", fmt::format("margin-left:{}em", 1.5 * static_cast<double>(depth))}});
  }
  html += block("ul", "\n" + items, {{"class", "proof"}});
  if (!proof->complete()) html += paragraph(proof->gap);
  return html;
}

std::string identities(const checks::Report& report) {
  std::string html;
  for (const auto* piece : all_of<checks::ExactIdentity>(report)) {
    html += heading("Exact identities");
    html += paragraph(piece->detail);
    std::vector<std::string> items;
    for (const std::string& identity : piece->identities) items.push_back(prose(identity));
    html += list(items);
  }
  return html;
}

std::string agreements(const checks::Report& report) {
  const auto pieces = all_of<checks::Agreement>(report);
  if (pieces.empty()) return "";
  HtmlRows rows;
  for (const auto* a : pieces) {
    std::string routes;
    for (const std::string& route : a->routes) {
      routes += (routes.empty() ? "" : "<span class=\"against\">against</span> ") + prose(route) + " ";
    }
    std::string cases = fmt::format("{} of {}", a->effective, a->cases);
    if (a->effective < a->required) cases += fmt::format(" ({} required)", a->required);
    rows.push_back({prose(a->what), routes, number(a->worst), number(a->tolerance), cases});
  }
  return heading("Agreement of unrelated routes") +
         table_element("Agreement of unrelated routes",
                       {"quantity", "routes", "largest relative difference", "tolerance", "effective cases"}, rows) +
         details(pieces);
}

std::string rates(const checks::Report& report) {
  const auto pieces = all_of<checks::ConvergenceRate>(report);
  if (pieces.empty()) return "";
  HtmlRows rows;
  for (const auto* r : pieces) {
    rows.push_back({prose(r->what), fmt::format("{:.3g} ± {:.2g}", r->measured, r->error_bar),
                    fmt::format("{:.3g} ± {:.2g}", r->expected, r->tolerance)});
  }
  return heading("Rates of convergence") +
         table_element("Rates of convergence", {"error of", "power measured", "power expected"}, rows) +
         details(pieces);
}

std::string counterexamples(const checks::Report& report) {
  std::vector<std::string> items;
  for (const auto* c : all_of<checks::Counterexample>(report)) items.push_back(prose(c->detail + " at " + c->where));
  return list(items, heading("Counterexample"));
}

std::string beyond(const checks::Report& report, std::span<const checks::Report> reports) {
  std::string html;
  for (const auto* b : all_of<checks::BeyondCalculation>(report)) {
    html += heading("Beyond calculation") + paragraph(b->reason);
    std::vector<std::string> items;
    for (const std::string& id : b->consequences) {
      const std::string code = element("code", escaped(id));
      const checks::Report* found = report_on(id, reports);
      items.push_back(found == nullptr
                          ? code + " (not in this run)"
                          : fmt::format("{}: {}", element("a", code, {{"href", "#" + id}}), name_of(found->verdict)));
    }
    html += list(items, block("p", "What follows from it and can be calculated:"));
  }
  return html;
}

}  // namespace

const checks::Report* report_on(std::string_view id, std::span<const checks::Report> reports) {
  const auto found = std::ranges::find(reports, id, [](const auto& r) { return std::string_view(r.claim.id); });
  return found == reports.end() ? nullptr : &*found;
}

std::string badge(checks::Verdict verdict) {
  return element("span", name_of(verdict), {{"class", fmt::format("badge {}", name_of(verdict))}});
}

std::string evidence_html(const checks::Report& report, std::span<const checks::Report> reports) {
  std::string html = counterexamples(report) + proof_html(report) + identities(report) + agreements(report) +
                     rates(report) + beyond(report, reports);
  if (!report.note.empty()) html += block("p", prose(report.note), {{"class", "note"}});
  return html;
}

std::string controls_html(const checks::Report& report) {
  if (report.controls.empty()) return "";
  std::string items;
  for (const checks::ControlReport& control : report.controls) {
    const std::string_view mark = control.refuted ? "refuted" : "not refuted";
    const std::string detail = control.detail.empty() ? "" : element("span", prose(control.detail), {{"class", "by"}});
    items += block("li", element("span", mark, {{"class", control.refuted ? "mark" : "mark survived"}}) + " " +
                             prose(control.name) + " " + detail);
  }
  return block("ul", "\n" + items, {{"class", "controls"}});
}

}  // namespace steadyslide::app
