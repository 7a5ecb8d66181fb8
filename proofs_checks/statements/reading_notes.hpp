#pragma once
// Places where the text of the paper that this project holds and the mathematics disagree: the printed reading, the
// derived one, and the evidence. That text was extracted from a PDF: each note says whether extraction may have done
// it. The notes stand in reading_notes.md; what a run and the local equation say is added to them.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/kit/run.hpp"

namespace steadyslide::proofs_checks {

/// Stands beside their number, wherever that is said.
inline constexpr std::string_view printed_page = "The printed page was not seen.";

struct ReadingNote {
  std::string id;
  std::string place;
  std::string printed;
  std::string derived;
  std::string evidence;
  /// The place of the fault: in a formula "print", "extraction", or "undecided" between the two; else "words", the paper's,
  /// which extraction does not change.
  std::string fault;
  /// That examines the derived reading; empty where the local equation alone decides.
  std::string claim;
  /// Of the claim: the printed reading; empty where it is no formula that a check could take.
  std::string control = {};
};

/// The evidence is taken from the reports: the control that is the printed reading, and what refuted it; then a
/// sentence on whether extraction may have done it. A note whose claim was not run says so. Formulas stand between
/// backticks, as in claims.
std::vector<ReadingNote> reading_notes(std::span<const Report> reports);

}  // namespace steadyslide::proofs_checks
