#pragma once
// Pressures on cells whose gap has its minimum 0 in every cell in contact, not its mean.
//
// A state of the discrete problem has mean gap 0 on its cells in contact, so that it penetrates in each of them by what the
// gap varies within it. An error bound that asks for gap >= 0 at every place has to lift the indenter by the worst of
// these. Here each cell's profile is lowered by
//
//   delta_i = (mean of the gap over cell i) - (its least value there),
//
// and the problem on cells solved again; delta depends on the pressures, so that this is repeated as long as it gains.
// All by Galerkin's rule. The least values are taken at a few places of each cell, in double: what is proved of the state, others prove.

#include "numeric/variational/nested_solve.hpp"

namespace steadyslide::numeric::variational {

/// From what was found on cells, which is returned where nothing better is. A pass may lose what the one before it gained.
DiscreteState touching_state(const ContactProblem& problem, const MeshSolution& found);

}  // namespace steadyslide::numeric::variational
