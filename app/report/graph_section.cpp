// The section "What rests on what": a graph of the entries that rest on other entries, and a table of the classical
// theorems that entries rest on.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/html/mathml.hpp"
#include "app/report/sections.hpp"
#include "app/verify/proof_writers.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

using Names = std::set<std::string>;

/// An entry that rests on other entries, or that other entries rest on.
struct Node {
  std::string id;
  Names below;
  std::size_t column = 0;  ///< one more than the largest column of the entries in `below`
  double row = 0;
};

std::map<std::string, Node> nodes_of(std::span<const checks::Report> reports) {
  std::map<std::string, Node> nodes;
  for (const checks::Report& report : reports) {
    const checks::CheckedProof* proof = report.proof();
    if (proof == nullptr) continue;
    for (const std::string& id : names_used(*proof, checks::ProofStep::Kind::entry)) {
      nodes[report.claim.id].below.insert(id);
      nodes[id];
    }
  }
  for (auto& [id, node] : nodes) node.id = id;
  // Proofs have no cycles, so that the columns are final after at most one pass for each entry.
  for (std::size_t step = 0; step < nodes.size(); ++step) {
    for (auto& [id, node] : nodes) {
      for (const std::string& below : node.below) node.column = std::max(node.column, nodes[below].column + 1);
    }
  }
  return nodes;
}

constexpr double letter = 6.1, line = 17, between = 60;

/// Returns the columns of the graph. A column is sorted by the mean row of the entries below.
std::vector<std::vector<Node*>> columns_of(std::map<std::string, Node>& nodes) {
  std::vector<std::vector<Node*>> columns;
  for (auto& [id, node] : nodes) {
    columns.resize(std::max(columns.size(), node.column + 1));
    columns[node.column].push_back(&node);
  }
  for (std::vector<Node*>& column : columns) {
    for (Node* node : column) {
      for (const std::string& id : node->below) node->row += nodes[id].row / static_cast<double>(node->below.size());
    }
    std::ranges::stable_sort(column, {}, &Node::row);
    for (std::size_t k = 0; k < column.size(); ++k)
      column[k]->row = static_cast<double>(k) - static_cast<double>(column.size()) / 2;
  }
  return columns;
}

std::string graph(std::span<const checks::Report> reports) {
  std::map<std::string, Node> nodes = nodes_of(reports);
  if (nodes.empty()) return "";
  const std::vector<std::vector<Node*>> columns = columns_of(nodes);
  std::size_t longest = 0;
  for (const auto& column : columns) longest = std::max(longest, column.size());
  std::vector<double> left{4}, right;
  for (const auto& column : columns) {
    std::size_t letters = 0;
    for (const Node* node : column) letters = std::max(letters, node->id.size());
    right.push_back(left.back() + letter * static_cast<double>(letters));
    left.push_back(right.back() + between);
  }
  const auto y = [&](const Node& node) { return (node.row + static_cast<double>(longest) / 2 + 1) * line; };
  std::string edges, labels;
  for (const auto& [id, node] : nodes) {
    for (const std::string& name : node.below) {
      const Node& below = nodes.at(name);
      const double from = left[below.column] + letter * static_cast<double>(name.size()) + 2,
                   to = left[node.column] - 3;
      edges += fmt::format("M{:.0f} {:.0f}C{:.0f} {:.0f} {:.0f} {:.0f} {:.0f} {:.0f}", from, y(below),
                           right[below.column] + between / 2, y(below), to - between / 2, y(node), to, y(node));
    }
    const checks::Report* report = report_on(id, reports);
    const std::string text =
        fmt::format(R"(<text x="{:.0f}" y="{:.0f}"{}>{}</text>)", left[node.column], y(node) + 3.5,
                    report ? fmt::format(R"( class="{}")", name_of(report->verdict)) : "", escaped(id));
    labels += report ? link(text, id) : text;
  }
  const std::string svg =
      fmt::format(R"(<svg viewBox="0 0 {:.0f} {:.0f}" role="group" aria-label="What rests on what">)", right.back() + 4,
                  (static_cast<double>(longest) + 1) * line) +
      fmt::format(R"(<path d="{}"/>{}</svg>)", edges, labels);
  return block("figure",
               region("graph", "What rests on what", svg) +
                   block("figcaption",
                         fmt::format("<strong>{}</strong> Entries whose proofs rest on other entries, to the right of "
                                     "those. The others rest on decisions and classical theorems alone.",
                                     figure_mark)));
}

std::string theorems(std::span<const checks::Report> reports) {
  std::map<std::string, std::vector<std::string>> used;
  for (const checks::Report& report : reports) {
    const checks::CheckedProof* proof = report.proof();
    if (proof == nullptr) continue;
    for (const std::string& name : names_used(*proof, checks::ProofStep::Kind::theorem))
      used[name].push_back(link(escaped(report.claim.id), report.claim.id));
  }
  HtmlRows rows;
  for (const auto& [name, entries] : used) {
    rows.push_back({element("code", escaped(name), {{"id", "theorem-" + name}}),
                    cited_prose(theorem_words("theorem " + name)),
                    folded(fmt::format("{} {}", entries.size(), entries.size() == 1 ? "entry" : "entries"),
                           fmt::format("{}", fmt::join(entries, ", ")))});
  }
  if (rows.empty()) return "";
  return table_element("Classical theorems", {"theorem", "what it says", "used by"}, rows,
                       "Classical theorems that proofs of the ledger use.");
}

}  // namespace

std::string theorem_words(std::string_view by) {
  constexpr std::string_view kind = "theorem ";
  if (!by.starts_with(kind)) return "";
  const auto found = checks::theory().theorems.find(std::string(by.substr(kind.size())));
  return found == checks::theory().theorems.end() ? "" : found->second.front().words;
}

std::string rests_html(const VerifyResult& result) { return graph(result.reports) + theorems(result.reports); }

}  // namespace steadyslide::app
