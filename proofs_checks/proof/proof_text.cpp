#include "proofs_checks/proof/proof_text.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace steadyslide::proofs_checks {
namespace {

constexpr std::array<std::string_view, 7> kinds{"identity",   "sign",      "enclosure", "theorem",
                                                "definition", "inference", "entry"};

/// Adds the steps of a line, "theorem plemelj: plemelj(flat-punch), ...".
void add_steps(std::vector<ProofStep>& steps, std::string_view line) {
  const std::string_view by = line.substr(0, line.find(": "));
  const std::size_t space = by.find(' ');
  const auto found = std::ranges::find(kinds, by.substr(0, space));
  const auto kind = static_cast<ProofStep::Kind>(found - kinds.begin());
  const std::string name(space == std::string_view::npos ? "" : by.substr(space + 1));
  const bool named = kind == ProofStep::Kind::theorem || kind == ProofStep::Kind::entry;
  if (by == line || found == kinds.end() || named == name.empty()) {
    throw std::logic_error("no such step of a proof: " + std::string(line));
  }
  for (Fact& fact : parse_facts(line.substr(by.size() + 2))) steps.push_back({std::move(fact), kind, name});
}

}  // namespace

ProofText parse_proof(const std::vector<std::string_view>& lines) {
  ProofText proof;
  std::array<std::pair<std::string_view, std::string>, 3> sentences{
      {{"For ", {}}, {"Assumes ", {}}, {"Concludes ", {}}}};
  std::string* sentence = nullptr;
  for (std::string_view line : lines) {
    if (line.starts_with("- ")) {
      add_steps(proof.steps, line.substr(2));
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
