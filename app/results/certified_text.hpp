#pragma once
// A proved solution as text: numbers enclosed by balls replace the solver's estimates.

#include "app/results/solution_text.hpp"
#include "enclosure/cells/cell_bound.hpp"
#include "enclosure/loads/load_path.hpp"

namespace steadyslide::app {

/// Replaces the numbers in `text`, the text of the approximation from which the proof began. If the proof failed, the
/// numbers stay, and the failed condition is the reason. `threads` threads share the work on the numbers.
void certify(SolutionText& text, const Problem& problem, const enclosure::ContactProof& proof,
             const SolutionWanted& wanted, unsigned threads);

/// Puts the enclosed load shares and the enclosed effective friction into the text of a solution on cells. If the bound
/// is not proved, the failed condition is the reason.
void add_bound(SolutionText& text, const Problem& problem, const enclosure::CellBound& bound);

StretchText stretch_text(const enclosure::LoadStretch& stretch, int digits);

}  // namespace steadyslide::app
