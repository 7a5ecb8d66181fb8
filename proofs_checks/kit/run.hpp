#pragma once
// Runs claims with their controls and weighs the evidence. Prints nothing.

#include <algorithm>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "proofs_checks/kit/claim.hpp"
#include "proofs_checks/kit/verdict.hpp"

namespace steadyslide::proofs_checks {

struct ControlReport {
  std::string name;
  bool refuted;
  std::string detail;  ///< the counterexample; without one, what the check found
};

struct Report {
  ClaimText claim;
  Verdict verdict = Verdict::undecided;
  std::vector<Evidence> evidence;
  /// The reason why the verdict is weaker than the evidence: an exception's message, controls that were not refuted.
  std::string note;
  std::vector<ControlReport> controls;
  double seconds = 0;

  std::size_t controls_refuted() const;
  /// Returns the checked proof, or null if there is none.
  const CheckedProof* proof() const;
  /// True if no calculation decides the claim. It is undecided then, but this is not a failure.
  bool beyond_calculation() const;
};

/// Runs the claim and its controls. An exception inside the check leaves the claim undecided, with the message as note.
/// An exception inside a control leaves this control unrefuted. A quick run examines controls in double first; those
/// that are not refuted there are examined with the context's digits.
Report run(const Claim& claim, const Context& context);

/// True if the whole text matches a pattern of the shell: `*` (any text), `?` (any character), `[0-9]` (one of these).
bool matches_glob(const std::string& text, const std::string& pattern);

/// Returns the items whose name matches at least one of the patterns, in order; all items if there is no pattern.
/// `name` is the member with the name, by default the id.
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

/// The function that is called before each claim.
using Progress = std::function<void(std::size_t index, std::size_t total, const Claim& claim)>;

/// Runs the claims one after the other on the calling thread, because GiNaC and CLN allow no other. processes.hpp runs
/// them in several processes.
std::vector<Report> run_all(std::span<const Claim> claims, const Context& context, const Progress& progress = {});

/// Returns the number of reports with each verdict, from proved to refuted.
std::vector<std::pair<std::string_view, std::size_t>> count(std::span<const Report> reports);
/// Returns these numbers as text: "3 proved, 2 supported, 0 undecided, 0 refuted".
std::string counts_line(std::span<const Report> reports);

/// The rules on which proofs rest, by name: those that hold on instances, and those in words, which only a reader can
/// judge.
struct ProofRules {
  std::set<std::string> run, in_words;
};
ProofRules rules_of(std::span<const Report> reports);
/// Returns "12 run on instances, 30 in words".
std::string rules_line(std::span<const Report> reports);

/// True if no claim is refuted, and every undecided claim is beyond calculation.
bool settled(std::span<const Report> reports);

}  // namespace steadyslide::proofs_checks
