#include "proofs_checks/proof/proof_text.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "proofs_checks/proof/markdown.hpp"

namespace steadyslide::proofs_checks {
namespace {

constexpr std::array<std::string_view, 7> kinds{"identity",   "sign",      "enclosure", "theorem",
                                                "definition", "inference", "entry"};

void add_steps(std::vector<ProofStep>& steps, const std::vector<std::string>& cells) {
  if (cells.size() != 2) throw std::logic_error("not a step, facts and by what: " + cells.at(0));
  const std::size_t space = cells[1].find(' ');
  const auto found = std::ranges::find(kinds, cells[1].substr(0, space));
  const auto kind = static_cast<ProofStep::Kind>(found - kinds.begin());
  const std::string name = space == std::string::npos ? "" : cells[1].substr(space + 1);
  const bool named = kind == ProofStep::Kind::theorem || kind == ProofStep::Kind::entry;
  if (found == kinds.end() || named == name.empty()) throw std::logic_error("no such step of a proof: " + cells[1]);
  for (Fact& fact : parse_facts(cells[0])) steps.push_back({std::move(fact), kind, name});
}

}  // namespace

ProofText parse_proof(const std::vector<std::string_view>& lines) {
  ProofText proof;
  std::array<std::pair<std::string_view, std::string>, 3> sentences{
      {{"For ", {}}, {"Assumes ", {}}, {"Concludes ", {}}}};
  std::string* sentence = nullptr;
  bool in_rows = false;
  for (std::string_view line : lines) {
    if (line.starts_with('|')) {
      if (is_rule_of_table(line)) {
        in_rows = true;
      } else if (in_rows) {
        add_steps(proof.steps, cells_of(line));
      }
      continue;
    }
    if (line.empty()) {
      sentence = nullptr;
      continue;
    }
    for (auto& [opening, text] : sentences) {
      if (!line.starts_with(opening)) continue;
      sentence = &text;
      line.remove_prefix(opening.size());
    }
    if (!sentence) throw std::logic_error("neither For, Assumes nor Concludes: " + std::string(line));
    *sentence += (sentence->empty() ? "" : " ") + std::string(line);
  }
  if (!sentences[0].second.empty()) proof.parameters = parse_box(sentences[0].second);
  if (!sentences[1].second.empty()) proof.assumes = parse_facts(sentences[1].second);
  if (!sentences[2].second.empty()) proof.concludes = parse_facts(sentences[2].second);
  if (proof.concludes.empty() || proof.steps.empty())
    throw std::logic_error("a proof that concludes nothing, or has no step");
  return proof;
}

std::string by_what(const ProofStep& step) {
  return std::string(kinds[static_cast<std::size_t>(step.kind)]) + (step.name.empty() ? "" : " " + step.name);
}

}  // namespace steadyslide::proofs_checks
