#pragma once
// A uniform mesh solved through coarser ones, each half as fine: the contact found on one is the next one's start.

#include <optional>

#include "numeric/variational/active_set.hpp"
#include "numeric/variational/certificate.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::numeric::variational {

/// The solution on one mesh.
struct MeshSolution {
  std::shared_ptr<const DiscreteProblem> problem;
  ActiveSetResult found;
  bool by_lemke = false;  ///< the active sets cycled and Lemke's method went on
};

struct NestedResult {
  MeshSolution fine;
  MeshSolution coarse;  ///< on half as many cells: the difference shows the error
  /// States on still coarser meshes, each half as fine as the one before, three at most.
  std::vector<DiscreteState> coarser;
  Certificate certificate;
};

/// `start`: the contact that the coarsest mesh starts from, on equal cells of any number; absent: contact everywhere.
/// Progress is called after each step of the active sets, in a measure of the cost.
NestedResult solve_nested(const ContactProblem& problem, const VariationalOptions& options,
                          const std::optional<CellSet>& start = {});

/// A problem that is on its cells already, from a contact set, not empty, and a state.
MeshSolution solve_on_cells(std::shared_ptr<const DiscreteProblem> problem, CellSet start, const DiscreteState& guess,
                            const ActiveSetOptions& options);

/// A contact set on `cells` equal cells, from one on any other number of them.
CellSet prolonged(const CellSet& set, std::size_t cells);

}  // namespace steadyslide::numeric::variational
