#pragma once
// Pressures on cells for which the minimum of the gap, not its mean, is 0 in every cell in contact.
//
// A state of the discrete problem has mean gap 0 on its cells in contact. So in each of them it penetrates by the
// variation of the gap. An error bound that requires gap >= 0 at every place must lift the indenter by the largest of
// these. Here each cell's profile is lowered by
//
//   delta_i = (mean of the gap over cell i) - (its minimum there),
//
// and the problem on cells is solved again. delta depends on the pressures, so this is repeated as long as it improves
// the bound. Galerkin's rule is used. The minima are taken over a few places of each cell, in double. This proves
// nothing; the proof is made elsewhere.

#include "numeric/variational/nested_solve.hpp"

namespace steadyslide::numeric::variational {

/// Returns the best state found, starting from `found`, which is returned if there is no better one. A pass may be
/// worse than the one before.
DiscreteState touching_state(const ContactProblem& problem, const MeshSolution& found);

}  // namespace steadyslide::numeric::variational
