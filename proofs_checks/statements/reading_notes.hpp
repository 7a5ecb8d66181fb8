#pragma once
// Places where the paper's text that this project holds contradicts the mathematics: the printed reading, the derived
// one, and the evidence. The text was extracted from a PDF; each note says if the extraction may have caused the
// difference. The notes stand in reading_notes.md; the verdicts of a run and the result of the local equation are added
// to them.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/kit/run.hpp"

namespace steadyslide::proofs_checks {

/// The three groups of notes, each with its faults.
struct NoteGroup {
  std::string_view name;
  std::vector<std::string_view> faults;
};
inline const std::vector<NoteGroup> note_groups{{"formula", {"print", "extraction", "undecided"}},
                                                {"missing hypothesis", {"hypothesis"}},
                                                {"wording", {"wording"}}};

/// The sentence that stands beside the number of notes wherever it appears.
inline constexpr std::string_view printed_page = "The printed page was not seen.";

struct ReadingNote {
  std::string id;
  std::string place;
  std::string printed;
  std::string derived;
  std::string evidence;
  /// In a formula the place of the fault: "print", "extraction", or "undecided" between these two. In words, which
  /// extraction does not change: "hypothesis" if one is missing, "wording" otherwise.
  std::string fault;
  /// The claim that examines the derived reading; empty if the local equation alone decides it.
  std::string claim;
  /// The control of this claim that is the printed reading; empty if a check cannot use the printed reading as a
  /// formula.
  std::string control = {};
};

/// Returns the notes with their evidence from the reports: the verdict of the claim, the result of the control that is
/// the printed reading, and a sentence on the extraction. If the claim was not run, the note says so. Formulas stand
/// between backticks, as in claims.
std::vector<ReadingNote> reading_notes(std::span<const Report> reports);

}  // namespace steadyslide::proofs_checks
