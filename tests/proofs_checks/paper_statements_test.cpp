#include "proofs_checks/statements/paper_statements.hpp"
#include "proofs_checks/kit/registry.hpp"
#include "support/test.hpp"

using namespace steadyslide::proofs_checks;

TEST_CASE("every statement of the paper has a claim, and every claim belongs to one statement") {
  std::multiset<std::string_view> named;
  for (const PaperStatement& statement : paper_statements()) {
    CAPTURE(statement.what);
    CHECK_FALSE(statement.claims.empty());
    named.insert(statement.claims.begin(), statement.claims.end());
  }
  for (const Claim& claim : registry()) CHECK_MESSAGE(named.count(claim.id) == 1, claim.id);
  for (const std::string_view id : named) {
    CAPTURE(id);
    CHECK(std::ranges::any_of(registry(), [&](const Claim& claim) { return claim.id == id; }));
  }
}
