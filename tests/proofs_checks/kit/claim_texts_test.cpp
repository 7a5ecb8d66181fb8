#include "proofs_checks/kit/registry.hpp"
#include "proofs_checks/kit/run.hpp"
#include "support/test.hpp"

using namespace steadyslide::proofs_checks;

namespace {

bool is_balanced(const std::string& text) { return std::ranges::count(text, '`') % 2 == 0; }

/// No formula is empty, and none begins or ends with a space: a backtick was forgotten there.
bool has_whole_formulas(const std::string& text) {
  for (std::size_t open = text.find('`'); open != std::string::npos;) {
    const std::size_t close = text.find('`', open + 1);
    if (close == std::string::npos) return false;
    if (close == open + 1 || text[open + 1] == ' ' || text[close - 1] == ' ') return false;
    open = text.find('`', close + 1);
  }
  return true;
}

bool has_near_miss(const Claim& claim) {
  return std::ranges::any_of(claim.controls, [](const Control& c) { return c.name.starts_with("near miss"); });
}

bool is_exact(const Claim& claim) {
  const std::vector<Evidence> evidence = claim.examine({numeric::Digits::sixteen, 1, true});
  return !evidence.empty() &&
         std::ranges::all_of(evidence, [](const Evidence& e) { return std::holds_alternative<ExactIdentity>(e); });
}

}  // namespace

TEST_CASE("every claim says what is stated, what is assumed and how it follows, with formulas between backticks") {
  for (const Claim& claim : registry()) {
    CAPTURE(claim.id);
    for (const std::string* text : {&claim.statement, &claim.hypotheses, &claim.derivation}) {
      CAPTURE(*text);
      CHECK(is_balanced(*text));
      CHECK(has_whole_formulas(*text));
    }
    if (!claim.controls.empty()) CHECK_FALSE(claim.derivation.empty());  // else beyond calculation
  }
}

TEST_CASE("every claim has a near miss among its controls, unless it is decided exactly") {
  for (const Claim& claim : registry()) {
    CAPTURE(claim.id);
    if (claim.controls.empty()) continue;  // beyond calculation
    CHECK((has_near_miss(claim) || is_exact(claim)));
  }
}

TEST_CASE("what is compared stands in a table, a row of which is a name, what it is, and both routes or none") {
  const std::string text = "# one\n\na source\n\n## Statement\n\na\n\n## Hypotheses\n\nb\n\n## Compared\n\n";
  const std::vector<QuantityText> rows =
      parse_claim_text(text +
                       "| name | what | measured by | predicted by |\n|---|---|---|---|\n| peak | largest \\|t\\| | "
                       "solved | 1 |\n| sign | it is negative | | |\n")
          .compared;
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].name == "peak");
  CHECK(rows[0].what == "largest |t|");
  CHECK(rows[0].routes == std::vector<std::string>{"solved", "1"});
  CHECK(rows[1].routes.empty());
  CHECK_THROWS_AS(parse_claim_text(text + "| peak | largest pressure | solved | |\n"), std::logic_error);
  CHECK_THROWS_AS(parse_claim_text(text + "no row\n"), std::logic_error);
}
