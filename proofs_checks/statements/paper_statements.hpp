#pragma once
// The statements of the paper in its order, read from paper_statements.md. Each lists the claims that express it or
// parts of it, and the claims that examine instances. Its verdict is the weakest one of the claims that express it. A
// test checks that every listed claim exists and that every claim of the ledger is listed.

#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "proofs_checks/kit/run.hpp"

namespace steadyslide::proofs_checks {

struct PaperStatement {
  /// "theorem 2", "(5)-(7)"; empty for a statement that goes beyond the paper.
  std::string_view place;
  std::string_view what;  ///< our own phrase; formulas between backticks, as in claims
  /// A phrase: the range in which the verdict holds, if `what` does not state it.
  std::string_view scope;
  std::vector<std::string_view> claims;     ///< claims that express the statement
  std::vector<std::string_view> instances;  ///< claims that examine instances of it
  /// In words, how the proved statement is narrower than the printed one; empty if it is not.
  std::string_view restriction;
  bool reconstructed = false;  ///< the printed words were not seen
};

const std::vector<PaperStatement>& paper_statements();

/// Returns the weakest verdict of the claims that express the statement, or nothing if one of them was not examined.
std::optional<Verdict> verdict_of(const PaperStatement& statement, std::span<const Report> reports);

/// Returns the verdict in words: "proved", "proved, restricted", "proved, as reconstructed", or the name of another
/// verdict.
std::string_view standing(const PaperStatement& statement, Verdict verdict);

/// Returns the number of the paper's statements with each standing, from proved to refuted. Statements beyond the paper,
/// and those with a claim that was not examined, do not count.
std::vector<std::pair<std::string_view, std::size_t>> statement_counts(std::span<const Report> reports);

/// Returns "20 proved; 1 proved, restricted; ...; 0 refuted" for the paper's statements, without those beyond it.
/// Returns an empty text if a claim of a statement was not examined.
std::string statements_line(std::span<const Report> reports);

}  // namespace steadyslide::proofs_checks
