// What may stay undecided, and what is checked in its place. By structure: the ledger is not run.

#include "proofs_checks/kit/registry.hpp"
#include "proofs_checks/kit/run.hpp"
#include "support/test.hpp"

using namespace steadyslide::proofs_checks;

namespace {

/// Such a claim has nothing to be run: no controls, and its examination answers at once.
const BeyondCalculation* beyond(const Claim& claim, std::vector<Evidence>& evidence) {
  if (!claim.controls.empty()) return nullptr;
  evidence = claim.examine({});
  return evidence.size() == 1 ? std::get_if<BeyondCalculation>(&evidence.front()) : nullptr;
}

}  // namespace

TEST_CASE("exactly six statements are beyond calculation, and each says what is checked instead") {
  std::map<std::string, BeyondCalculation> found;
  std::set<std::string> calculable;
  for (const Claim& claim : registry()) {
    CAPTURE(claim.id);
    std::vector<Evidence> evidence;
    if (const BeyondCalculation* why = beyond(claim, evidence)) {
      found.emplace(claim.id, *why);
      CHECK_FALSE(claim.derivation.empty());
    } else {
      // Without controls it could not be settled at all.
      CHECK_FALSE(claim.controls.empty());
      calculable.insert(claim.id);
    }
  }
  std::set<std::string> ids;
  for (const auto& [id, why] : found) {
    CAPTURE(id);
    ids.insert(id);
    CHECK_FALSE(why.reason.empty());
    CHECK(why.consequences.size() >= 3);
    CHECK(std::set<std::string>(why.consequences.begin(), why.consequences.end()).size() == why.consequences.size());
    for (const std::string& consequence : why.consequences)
      CHECK_MESSAGE(calculable.contains(consequence), consequence);
  }
  CHECK(ids == std::set<std::string>{"thm-01-existence", "thm-16", "thm-17", "thm-23", "thm-24", "thm-25"});
}

TEST_CASE("undecided is settled for what is beyond calculation, and for nothing else") {
  Report report{{}, Verdict::undecided, {BeyondCalculation{"no calculation", {"other"}}}, "", {}, 0};
  CHECK(report.beyond_calculation());
  CHECK(settled(std::vector<Report>{report}));
  report.evidence = {Agreement{"value", {}, "0", "1", 1, 0, 1, ""}};
  CHECK_FALSE(report.beyond_calculation());
  CHECK_FALSE(settled(std::vector<Report>{report}));
  report.evidence = {BeyondCalculation{}, Counterexample{"here", "it fails"}};
  report.verdict = Verdict::refuted;
  CHECK_FALSE(report.beyond_calculation());
  CHECK_FALSE(settled(std::vector<Report>{report}));
}
