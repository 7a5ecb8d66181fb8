// The evidence on a claim as HTML, one block for each kind.

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

#include "app/html/mathml.hpp"
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

std::string paragraph(std::string_view text) { return text.empty() ? "" : block("p", lined(text)); }

/// Returns a number such as 3.1e-52 with a power of ten. Other text is only escaped.
std::string number(const std::string& text) {
  const bool is_number = text.find_first_not_of("0123456789.e+-") == std::string::npos;
  return is_number ? lined("`" + text + "`") : escaped(text);
}

std::string list(const std::vector<std::string>& items, const std::string& title = "") {
  if (items.empty()) return "";
  std::string html;
  for (const std::string& item : items) html += block("li", item);
  return title + block("ul", "\n" + html);
}

/// Returns the details of all pieces. A detail that several pieces share is written once.
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

/// Returns the reason of a step, with a link to the entry or the classical theorem that it names.
std::string reason(const std::string& by) {
  for (const auto& [kind, target] : {std::pair("entry ", ""), {"theorem ", "theorem-"}}) {
    if (by.starts_with(kind))
      return kind + link(escaped(by.substr(std::strlen(kind))), target + by.substr(std::strlen(kind)));
  }
  return escaped(by);
}

/// Returns the words of a step. Those of a classical theorem stand in the table of theorems.
std::string words_of(const checks::ProofNode& node) {
  std::string html;
  for (const std::string& words : node.words) {
    if (words != theorem_words(node.by)) html += span("words", lined(words));
  }
  return html;
}

/// Returns the proof as nested lists: a conclusion, and in the list below it the facts that it rests on. Steps have
/// numbers; a step that was shown before has its number alone.
std::string proof_html(const checks::Report& report) {
  const checks::CheckedProof* proof = report.proof();
  if (!proof) return "";
  std::string html;
  if (!proof->text.parameters.empty()) html += block("p", prose("For `" + text_of(proof->text.parameters) + "`."));
  std::string tree;
  std::map<std::size_t, std::size_t> numbers;
  std::size_t level = 0;
  for (const auto& [at, depth, again] : tree_of(*proof)) {
    const checks::ProofNode& node = proof->nodes[at];
    for (; level > depth; --level) tree += "</li></ul>";
    tree += level < depth || tree.empty() ? "<ul>" : "</li>";
    level = depth;
    if (again) {
      tree += fmt::format("\n<li>({}) above", numbers.at(at));
      continue;
    }
    const std::size_t number = numbers.size() + 1;
    numbers.emplace(at, number);
    tree += fmt::format("\n<li>({}) {} {}{}", number, lined(checks::theory().sentence(node.fact)),
                        span("by", reason(node.by)), words_of(node));
  }
  for (std::size_t k = 0; k <= level && !tree.empty(); ++k) tree += "</li></ul>";
  html += block("div", tree, {{"class", "proof"}});
  if (!proof->complete()) return heading("A proof with a gap") + html + paragraph(proof->gap);
  return folded("Proof: " + escaped(count_of_steps(*proof)), html);
}

std::string identities(const checks::Report& report) {
  std::string html;
  for (const auto* piece : all_of<checks::ExactIdentity>(report)) {
    html += heading("Exact identities");
    html += paragraph(piece->detail);
    std::vector<std::string> items;
    for (const std::string& identity : piece->identities) items.push_back(lined(identity));
    constexpr std::size_t few = 6;
    html += items.size() <= few ? list(items) : folded(fmt::format("{} identities", items.size()), list(items));
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
      routes += (routes.empty() ? "" : "<span class=\"against\">against</span> ") + lined(route) + " ";
    }
    std::string cases = fmt::format("{} of {}", a->effective, a->cases);
    if (a->effective < a->required) cases += fmt::format(" ({} required)", a->required);
    rows.push_back({lined(a->what), routes, number(a->worst), number(a->tolerance), cases});
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
    const auto with_bar = [](double value, double bar) {
      return span("n", fmt::format("{:.3f} ± {:.3f}", value, bar));
    };
    rows.push_back({lined(r->what), with_bar(r->measured, r->error_bar), with_bar(r->expected, r->tolerance)});
  }
  return heading("Rates of convergence") +
         table_element("Rates of convergence", {"error of", "power measured", "power expected"}, rows) +
         details(pieces);
}

std::string counterexamples(const checks::Report& report) {
  std::vector<std::string> items;
  for (const auto* c : all_of<checks::Counterexample>(report)) items.push_back(lined(c->detail + " at " + c->where));
  return list(items, heading("Counterexample"));
}

std::string beyond(const checks::Report& report, std::span<const checks::Report> reports) {
  std::string html;
  for (const auto* b : all_of<checks::BeyondCalculation>(report)) {
    html += heading("Beyond calculation") + paragraph(b->reason);
    std::vector<std::string> items;
    for (const std::string& id : b->consequences) {
      const checks::Report* found = report_on(id, reports);
      items.push_back(found == nullptr ? code(id) + " (not in this run)"
                                       : fmt::format("{}: {}", link(code(id), id), name_of(found->verdict)));
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

std::string badge(checks::Verdict verdict) { return span(fmt::format("badge {}", name_of(verdict)), name_of(verdict)); }

std::string evidence_html(const checks::Report& report, std::span<const checks::Report> reports) {
  std::string html = counterexamples(report) + proof_html(report) + identities(report) + agreements(report) +
                     rates(report) + beyond(report, reports);
  if (!report.note.empty()) html += block("p", lined(report.note), {{"class", "note"}});
  return html;
}

std::string controls_html(const checks::Report& report) {
  if (report.controls.empty()) return "";
  // A proof without one of its steps has a gap. The name of the step suffices.
  constexpr std::string_view left_out = "without the step ";
  std::string items, steps;
  for (const checks::ControlReport& control : report.controls) {
    const std::string_view name = control.name;
    if (control.refuted && name.starts_with(left_out)) {
      steps += (steps.empty() ? "" : ", ") + code(name.substr(left_out.size()));
      continue;
    }
    // A refuted variant is shown by its name, which describes the fault. A variant that is not refuted has its details,
    // too.
    const std::string detail = control.detail.empty() ? "" : " " + span("by", lined(control.detail));
    items += control.refuted ? block("li", lined(control.name))
                             : block("li", "not refuted: " + lined(control.name) + detail, {{"class", "survived"}});
  }
  if (!steps.empty()) items += block("li", "the proof without one of its steps, which leaves a gap: " + steps);
  const std::string html = block("ul", "\n" + items, {{"class", "controls"}});
  const std::size_t n = report.controls.size(), refuted = report.controls_refuted();
  const std::string variants = fmt::format("{} wrong variant{}", n, n == 1 ? "" : "s");
  if (refuted == n) return folded(variants + (n == 1 ? ", refuted" : ", all refuted"), html);
  return block("p", fmt::format("{}, {} refuted", variants, refuted)) + html;
}

}  // namespace steadyslide::app
