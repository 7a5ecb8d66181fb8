#include "proofs_checks/kit/claim_text.hpp"

#include <algorithm>
#include <array>
#include <ranges>
#include <stdexcept>

#include "proofs_checks/kit/registry.hpp"
#include "proofs_checks/proof/markdown.hpp"

namespace steadyslide::proofs_checks {
namespace {

void read_row(ClaimText& text, std::string_view row) {
  const std::vector<std::string> cells = cells_of(row);
  if (!cells.empty() && (cells[0] == "name" || cells[0] == "about" || is_rule_of_table(row))) return;
  if (cells.size() == 3) {
    text.decided.push_back({cells[0], list_of(cells[1], ", "), list_of(cells[2], "; ")});
  } else if (cells.size() == 4 && !cells[0].empty() && !cells[1].empty() && cells[2].empty() == cells[3].empty()) {
    text.compared.push_back({cells[0], cells[1], {}});
    if (!cells[2].empty()) text.compared.back().routes = {cells[2], cells[3]};
  } else {
    throw std::logic_error(text.id + ": not a row of a name, what it is, and both routes or none: " + std::string(row));
  }
}

}  // namespace

ClaimText parse_claim_text(std::string_view document) {
  ClaimText text;
  std::string nowhere;
  std::string* part = &nowhere;  // null: within a table
  std::string in_its_place;
  std::vector<std::string_view> proof;
  bool in_proof = false;
  const std::array<std::pair<std::string_view, std::string*>, 9> parts{
      {{"## Statement", &text.statement},
       {"## Hypotheses", &text.hypotheses},
       {"## Derivation", &text.derivation},
       {"## Compared", nullptr},
       {"## Decided", nullptr},
       {"## Proof", nullptr},
       {"## Convergence", &text.convergence},
       {"## Beyond calculation", &text.beyond_calculation},
       {"## Checked in its place", &in_its_place}}};
  for (const auto characters : std::views::split(document, '\n')) {
    const std::string_view line(characters.begin(), characters.end());
    if (line.starts_with("# ")) {
      text.id = line.substr(2);
      part = &text.source;
    } else if (line.starts_with('#')) {
      const auto found = std::ranges::find(parts, line, [](const auto& p) { return p.first; });
      if (found == parts.end()) throw std::logic_error(text.id + ": no such part of a claim: " + std::string(line));
      part = found->second;
      in_proof = line == "## Proof";
    } else if (in_proof) {
      proof.push_back(line);
    } else if (!part && !line.empty()) {
      read_row(text, line);
    } else if (!line.empty()) {
      if (!part->empty()) *part += ' ';
      *part += line;
    }
  }
  if (!nowhere.empty() || text.id.empty() || text.source.empty() || text.statement.empty() || text.hypotheses.empty()) {
    throw std::logic_error("not the text of a claim: " + (text.id.empty() ? nowhere : text.id));
  }
  if (!proof.empty()) text.proof = parse_proof(proof);
  if (!in_its_place.empty()) text.checked_in_its_place = list_of(in_its_place, ", ");
  return text;
}

ClaimText claim_text(std::string_view id) {
  for (const ClaimEntry& entry : claim_list()) {
    if (entry.id == id) return parse_claim_text(entry.document);
  }
  throw std::logic_error("no text of a claim " + std::string(id));
}

}  // namespace steadyslide::proofs_checks
