#include "app/verify/proof_writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/html/mathml.hpp"

namespace steadyslide::app {
namespace {

namespace checks = proofs_checks;

std::vector<std::string> texts_of(const std::vector<checks::Fact>& facts) {
  std::vector<std::string> texts;
  for (const checks::Fact& fact : facts) texts.push_back(text_of(fact));
  return texts;
}

}  // namespace

void write_proof(const checks::CheckedProof& proof, Output& output) {
  if (!proof.text.parameters.empty()) output.write(fmt::format("  for {}\n", text_of(proof.text.parameters)));
  for (const auto& [at, depth, again] : tree_of(proof)) {
    const checks::ProofNode& node = proof.nodes[at];
    const std::string indent(2 * depth + 2, ' ');
    output.write(fmt::format("{}{}  [{}]{}\n", indent, text_of(node.fact), node.by, again ? ", see above" : ""));
    if (again) continue;
    output.write(fmt::format("{}    {}\n", indent, checks::theory().sentence(node.fact)));
    for (const std::string& words : node.words) output.write(fmt::format("{}    - {}\n", indent, words));
  }
  if (!proof.complete()) output.write(fmt::format("  gap: {}\n", proof.gap));
}

nlohmann::ordered_json proof_json(const checks::CheckedProof& proof) {
  nlohmann::ordered_json json{{"complete", proof.complete()}};
  if (!proof.complete()) json["gap"] = proof.gap;
  json["for"] = text_of(proof.text.parameters);
  json["assumes"] = texts_of(proof.text.assumes);
  json["concludes"] = texts_of(proof.text.concludes);
  json["rules_in_words"] = proof.rules_in_words;
  json["steps"] = nlohmann::ordered_json::array();
  for (const checks::ProofNode& node : proof.nodes) {
    const std::string says = checks::theory().sentence(node.fact);
    json["steps"].push_back({{"fact", text_of(node.fact)},
                             {"says", says},
                             {"by", node.by},
                             {"words", node.words},
                             {"from", node.from},
                             {"html", {{"says", lined(says)}}}});
  }
  return json;
}

std::vector<std::string> names_used(const checks::CheckedProof& proof, checks::ProofStep::Kind kind) {
  std::vector<std::string> names;
  for (const checks::ProofStep& step : proof.text.steps) {
    if (step.kind == kind && std::ranges::find(names, step.name) == names.end()) names.push_back(step.name);
  }
  return names;
}

}  // namespace steadyslide::app
