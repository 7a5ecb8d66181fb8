#pragma once
// The paper, statement by statement, in its order, with the claims that say it or parts of it, and those that examine instances:
// what paper_statements.md lists. A statement is as good as the weakest of what says it. A test asks that every claim named there
// exists and that every claim of the ledger is named.

#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "proofs_checks/kit/run.hpp"

namespace steadyslide::proofs_checks {

struct PaperStatement {
  std::string_view place;                ///< "theorem 2", "(5)-(7)"; empty for what goes beyond the paper
  std::string_view what;                 ///< a phrase of our own; formulas between backticks, as in claims
  std::string_view scope;                ///< in which the verdict holds, where the words alone do not say it; a phrase
  std::vector<std::string_view> claims;  ///< that say it
  std::vector<std::string_view> instances;  ///< that examine instances of it
};

const std::vector<PaperStatement>& paper_statements();

/// The weakest verdict of the claims that say it; none if one of them was not examined.
std::optional<Verdict> verdict_of(const PaperStatement& statement, std::span<const Report> reports);

/// How many of the paper's statements have each verdict, from proved to refuted; those beyond it, and those that were not
/// examined as a whole, are left out.
std::vector<std::pair<std::string_view, std::size_t>> statement_counts(std::span<const Report> reports);

/// "20 proved, 9 supported, 5 undecided, 0 refuted": the paper's statements, those beyond it left out; empty where not all of
/// them were examined.
std::string statements_line(std::span<const Report> reports);

}  // namespace steadyslide::proofs_checks
