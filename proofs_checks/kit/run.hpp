#pragma once
// Runs claims with their controls and weighs what comes back. Prints nothing.

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "proofs_checks/kit/claim.hpp"
#include "proofs_checks/kit/verdict.hpp"

namespace steadyslide::proofs_checks {

struct ControlReport {
  std::string name;
  bool refuted;
  std::string detail;  ///< the counterexample, or what the check found instead of one
};

struct Report {
  ClaimText claim;
  Verdict verdict;
  std::vector<Evidence> evidence;
  std::string note;  ///< why the verdict is weaker than the evidence: an exception's message, surviving controls
  std::vector<ControlReport> controls;
  double seconds;

  std::size_t controls_refuted() const;
  /// Null if it has none.
  const CheckedProof* proof() const;
  /// No calculation decides it: an undecided claim that is no failure.
  bool beyond_calculation() const;
};

/// An exception inside the check leaves the claim undecided with its message as note; one inside a control leaves that
/// control unrefuted. A quick run examines controls in double first, and those at its own digits that survive this.
Report run(const Claim& claim, const Context& context);

/// Does the whole text match a pattern as the shell has them: `*` (any text), `?` (any character), `[0-9]` (one of
/// these)?
bool matches_glob(const std::string& text, const std::string& pattern);

/// Claims (or others) whose id (or other name) matches at least one of the patterns, in order; all of them if there is no
/// pattern.
template <class Named>
std::vector<Named> select(const std::vector<Named>& all, const std::vector<std::string>& patterns,
                          std::string Named::*name = &Named::id) {
  std::vector<Named> selected;
  for (const Named& one : all) {
    const auto matches = [&](const std::string& pattern) { return matches_glob(one.*name, pattern); };
    if (patterns.empty() || std::ranges::any_of(patterns, matches)) selected.push_back(one);
  }
  return selected;
}

/// Called before each claim.
using Progress = std::function<void(std::size_t index, std::size_t total, const Claim& claim)>;

/// One after the other on the calling thread (GiNaC and CLN allow no other); in several processes: processes.hpp.
std::vector<Report> run_all(std::span<const Claim> claims, const Context& context, const Progress& progress = {});

/// How many reports have each verdict, from proved to refuted.
std::vector<std::pair<std::string_view, std::size_t>> count(std::span<const Report> reports);
/// "3 proved, 2 supported, 0 undecided, 0 refuted".
std::string counts_line(std::span<const Report> reports);

/// Nothing refuted, and nothing undecided but what is beyond calculation.
bool settled(std::span<const Report> reports);

}  // namespace steadyslide::proofs_checks
