// The texts of claims, and the parts of claims that may stay undecided. By structure: the ledger is not run.

#include "proofs_checks/kit/registry.hpp"
#include "proofs_checks/kit/run.hpp"
#include "support/test.hpp"

using namespace steadyslide::proofs_checks;

namespace {

bool is_balanced(const std::string& text) { return std::ranges::count(text, '`') % 2 == 0; }

/// Checks that no formula is empty, and that none begins or ends with a space: there a backtick is missing.
bool has_whole_formulas(const std::string& text) {
  for (std::size_t open = text.find('`'); open != std::string::npos;) {
    const std::size_t close = text.find('`', open + 1);
    if (close == std::string::npos) return false;
    if (close == open + 1 || text[open + 1] == ' ' || text[close - 1] == ' ') return false;
    open = text.find('`', close + 1);
  }
  return true;
}

/// Such a claim has nothing to run: it has no controls, and its examination answers at once.
std::optional<BeyondCalculation> beyond(const Claim& claim) {
  if (!claim.controls.empty()) return std::nullopt;
  const std::vector<Evidence> evidence = claim.examine({});
  REQUIRE(evidence.size() == 1);
  return std::get<BeyondCalculation>(evidence.front());
}

/// Returns the reasons of undecided entries, by id: the rows of the table in docs/proofs.md.
std::map<std::string, std::string> documented_reasons() {
  std::map<std::string, std::string> reasons;
  bool in_part = false;
  for (const std::string& line : lines(file_text(STEADYSLIDE_PROOFS))) {
    if (line.starts_with("## ")) in_part = line == "## Undecided";
    const std::size_t bar = line.find(" | ");
    if (!in_part || !line.starts_with("| ") || bar == std::string::npos || line.starts_with("| entry ")) continue;
    reasons.emplace(line.substr(2, bar - 2), line.substr(bar + 3, line.size() - bar - 5));
  }
  return reasons;
}

}  // namespace

TEST_CASE("every claim says what is stated, what is assumed and how it follows, with formulas between backticks") {
  for (const Claim& claim : registry()) {
    CAPTURE(claim.id);
    std::vector<std::string> texts{claim.statement, claim.hypotheses, claim.derivation};
    for (const Control& control : claim.controls) texts.push_back(control.name);
    for (const Quantity& quantity : claim.compared) {
      texts.push_back(quantity.what);
      std::ranges::copy(quantity.routes, std::back_inserter(texts));
    }
    for (const std::string& text : texts) {
      CAPTURE(text);
      CHECK(is_balanced(text));
      CHECK(has_whole_formulas(text));
    }
    if (!claim.controls.empty()) CHECK_FALSE(claim.derivation.empty());  // otherwise beyond calculation
  }
}

TEST_CASE("what is compared stands in a table, a row of which is a name, what it is, and both routes or none") {
  const std::string text = "# one: a source\n\n**Statement.** a\n\n**Hypotheses.** b\n\n";
  const std::string head = "| compared | what | measured by | predicted by |\n|---|---|---|---|\n";
  const std::vector<Quantity> rows =
      parse_claim_text(text + head + "| peak | largest \\|t\\| | solved | 1 |\n| sign | it is negative | | |\n")
          .compared;
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].name == "peak");
  CHECK(rows[0].what == "largest |t|");
  CHECK(rows[0].routes == std::vector<std::string>{"solved", "1"});
  CHECK(rows[1].routes.empty());
  CHECK_THROWS_AS(parse_claim_text(text + "| peak | largest pressure | solved | |\n"), std::logic_error);
  CHECK_THROWS_AS(parse_claim_text(text + head + "no row\n"), std::logic_error);
}

TEST_CASE("how what is compared is compared stands in a last column, if that is not the usual way") {
  const std::string text = "# one: a source\n\n**Statement.** a\n\n**Hypotheses.** b\n\n";
  const std::string head = "| compared | what | measured by | predicted by | how |\n|---|---|---|---|---|\n";
  const auto rows = parse_claim_text(text + head +
                                     "| a | one | | | |\n| b | two | | | tolerance 1e-8, absolute |\n"
                                     "| c | three | | | at most, required 0.4, no near miss |\n")
                        .compared;
  REQUIRE(rows.size() == 3);
  const auto how = [](const Quantity& q) {
    return std::tuple(q.tolerance, q.absolute, q.at_most, q.required, q.near_miss);
  };
  CHECK(how(rows[0]) == std::tuple(0.0, false, false, 0.5, true));
  CHECK(how(rows[1]) == std::tuple(1e-8, true, false, 0.5, true));
  CHECK(how(rows[2]) == std::tuple(0.0, false, true, 0.4, false));
  CHECK_THROWS_AS(parse_claim_text(text + head + "| a | one | | | roughly |\n"), std::logic_error);
}

TEST_CASE(
    "what is beyond calculation stands with its reason in docs/proofs.md, and each says what is checked instead") {
  std::map<std::string, BeyondCalculation> found;
  std::set<std::string> calculable;
  for (const Claim& claim : registry()) {
    CAPTURE(claim.id);
    if (const auto why = beyond(claim)) {
      found.emplace(claim.id, *why);
      CHECK_FALSE(claim.derivation.empty());
    } else {
      calculable.insert(claim.id);
    }
  }
  std::map<std::string, std::string> reasons;
  for (const auto& claim : found) {
    CAPTURE(claim.first);
    const auto& why = claim.second;
    reasons.emplace(claim.first, why.reason);
    CHECK_FALSE(why.reason.empty());
    CHECK(why.consequences.size() >= 3);
    CHECK(std::set<std::string>(why.consequences.begin(), why.consequences.end()).size() == why.consequences.size());
    for (const std::string& consequence : why.consequences)
      CHECK_MESSAGE(calculable.contains(consequence), consequence);
  }
  CHECK(reasons == documented_reasons());
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
