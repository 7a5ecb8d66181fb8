#pragma once
// The reading notes without what a run adds to them.

#include <span>
#include <string_view>

namespace steadyslide::proofs_checks {

struct ReadingNoteEntry {
  std::string_view id;
  std::string_view place;
  std::string_view printed;
  std::string_view derived;
  std::string_view claim;
  std::string_view control;   ///< the claim's that is the printed reading; empty: `evidence` says what decides
  std::string_view evidence;  ///< beside the claim's
  std::string_view fault;     ///< print or extraction
};

/// In the order of the paper.
std::span<const ReadingNoteEntry> reading_note_entries();

}  // namespace steadyslide::proofs_checks
