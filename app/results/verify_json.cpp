#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/verify_writers.hpp"
#include "app/version.hpp"

namespace steadyslide::app {
namespace {

using Json = nlohmann::ordered_json;
namespace checks = proofs_checks;

Json claim_json(const checks::ClaimText& claim) {
  return {{"id", claim.id},
          {"source", claim.source},
          {"statement", claim.statement},
          {"hypotheses", claim.hypotheses},
          {"derivation", claim.derivation}};
}

Json report_json(const checks::Report& report) {
  Json json = claim_json(report.claim);
  json["verdict"] = name_of(report.verdict);
  json["evidence"] = Json::array();
  for (const checks::Evidence& evidence : report.evidence) {
    json["evidence"].push_back({{"kind", kind_of(evidence)}, {"detail", describe(evidence)}});
  }
  if (!report.note.empty()) json["evidence"].push_back({{"kind", "note"}, {"detail", report.note}});
  json["controls"] = {{"total", report.controls.size()}, {"refuted", report.controls_refuted()}};
  json["seconds"] = std::round(report.seconds * 1000) / 1000;
  return json;
}

}  // namespace

void write_verify_json(const VerifyResult& result, Output& output) {
  const checks::Counts counts = count(result.reports);
  Json json;
  json["schema"] = 1;
  json["version"] = version;
  json["digits"] = static_cast<int>(result.context.digits);
  json["seed"] = result.context.seed;
  json["counts"] = {{"proved", counts.proved},
                    {"supported", counts.supported},
                    {"undecided", counts.undecided},
                    {"refuted", counts.refuted}};
  json["claims"] = Json::array();
  for (const checks::Report& report : result.reports) json["claims"].push_back(report_json(report));
  json["reading_notes"] = Json::array();
  for (const checks::ReadingNote& note : result.notes) {
    json["reading_notes"].push_back({{"id", note.id},
                                     {"place", note.place},
                                     {"printed", note.printed},
                                     {"derived", note.derived},
                                     {"evidence", note.evidence}});
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

}  // namespace steadyslide::app
