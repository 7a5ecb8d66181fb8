#pragma once
// The paper, statement by statement, in its order, with the claims that examine each: what paper_statements.md lists. A
// test asks that every claim named there exists and that every claim of the ledger is named.

#include <string_view>
#include <vector>

namespace steadyslide::proofs_checks {

struct PaperStatement {
  std::string_view place;  ///< "theorem 2", "(5)-(7)"; empty for what goes beyond the paper
  std::string_view what;   ///< a phrase of our own; formulas between backticks, as in claims
  std::vector<std::string_view> claims;
};

const std::vector<PaperStatement>& paper_statements();

}  // namespace steadyslide::proofs_checks
