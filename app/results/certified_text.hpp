#pragma once
// A proved solution as text: the numbers that its balls enclose in the place of those that a solver estimated.

#include "app/results/solution_text.hpp"
#include "enclosure/cells/cell_bound.hpp"
#include "enclosure/loads/load_path.hpp"

namespace steadyslide::app {

/// `text` is that of the approximation that the proof began with. Not proved: its numbers stay, and the reason is its
/// failed condition. `threads` share the work on its numbers.
void certify(SolutionText& text, const Problem& problem, const enclosure::ContactProof& proof,
             const SolutionWanted& wanted, unsigned threads);

/// Puts load shares and effective friction as the bound encloses them into the text of a solution on cells; not proved: the
/// reason is its failed condition.
void add_bound(SolutionText& text, const Problem& problem, const enclosure::CellBound& bound);

StretchText stretch_text(const enclosure::LoadStretch& stretch, int digits);

}  // namespace steadyslide::app
