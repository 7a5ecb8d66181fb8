#include "proofs_checks/kit/transport.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace steadyslide::proofs_checks {

using Json = nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ExactIdentity, detail, identities)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Agreement, what, routes, worst, tolerance, cases, effective, required, detail)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ConvergenceRate, what, measured, error_bar, expected, tolerance, detail)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Counterexample, where, detail)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BeyondCalculation, reason, consequences)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Fact, word, things)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ProofNode, fact, by, words, from)
// The text of a proof is not stored: report_from() takes it from the claim.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CheckedProof, nodes, gap, rules_run, rules_in_words)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ControlReport, name, refuted, detail)

/// Writes an array of the alternative's index and its members.
static void to_json(Json& json, const Evidence& evidence) {
  std::visit([&](const auto& one) { json = {evidence.index(), one}; }, evidence);
}

static void from_json(const Json& json, Evidence& evidence) {
  const auto index = json.at(0).get<std::size_t>();
  const auto read = [&]<std::size_t... All>(std::index_sequence<All...>) {
    ((index == All ? json.at(1).get_to(evidence.emplace<All>()), 0 : 0), ...);
  };
  read(std::make_index_sequence<std::variant_size_v<Evidence>>());
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Report, verdict, evidence, note, controls, seconds)

std::string to_bytes(const Report& report) {
  std::string bytes;
  Json::to_cbor(report, bytes);
  return bytes;
}

Report report_from(std::string_view bytes, const Claim& claim) {
  Report report{claim, Verdict::undecided, {}, {}, {}, 0};
  Json::from_cbor(bytes).get_to(report);
  for (Evidence& e : report.evidence) {
    if (auto* proof = std::get_if<CheckedProof>(&e)) proof->text = claim.proof;
  }
  return report;
}

}  // namespace steadyslide::proofs_checks
