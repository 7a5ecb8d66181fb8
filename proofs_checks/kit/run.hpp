#pragma once
// Runs claims with their controls and weighs what comes back. Prints nothing.

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
  /// No calculation decides it: an undecided claim that is no failure.
  bool beyond_calculation() const;
  std::vector<std::string> survivors() const;
};

/// An exception inside the check leaves the claim undecided with its message as note; one inside a control leaves that
/// control unrefuted. A quick run examines controls in double first, and those at its own digits that survive this.
Report run(const Claim& claim, const Context& context);

/// Does the whole text match a pattern as the shell has them: `*` (any text), `?` (any character), `[0-9]` (one of
/// these)?
bool matches_glob(const std::string& text, const std::string& pattern);

/// The claims whose id matches at least one of the patterns, in order; all of them if there is no pattern.
std::vector<Claim> select(std::span<const Claim> claims, std::span<const std::string> patterns);

/// Called before each claim; false stops the run.
using Progress = std::function<bool(std::size_t index, std::size_t total, const Claim& claim)>;

/// One after the other on the calling thread (GiNaC and CLN allow no other).
std::vector<Report> run_all(std::span<const Claim> claims, const Context& context, const Progress& progress = {});

struct Counts {
  std::size_t proved = 0;
  std::size_t supported = 0;
  std::size_t undecided = 0;
  std::size_t refuted = 0;
};
Counts count(std::span<const Report> reports);

/// Nothing refuted, and nothing undecided but what is beyond calculation.
bool settled(std::span<const Report> reports);

}  // namespace steadyslide::proofs_checks
