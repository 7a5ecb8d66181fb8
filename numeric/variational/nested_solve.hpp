#pragma once
// Solves the discrete contact problem by active sets on one mesh. On a uniform mesh it first solves coarser meshes,
// each half as fine as the next; the contact on one mesh is the start on the next one.

#include <functional>

#include "numeric/variational/bordered_system.hpp"
#include "numeric/variational/certificate.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::numeric::variational {

struct ActiveSetOptions {
  int most_steps = 100;
  int patience = 10;              ///< steps without a new lowest number of wrong cells that count as cycling
  double tolerance = 1e-12;       ///< of the equations, relative to the profile's height if that exceeds c P
  double first_tolerance = 1e-5;  ///< tolerance while many cells are wrong
  std::size_t dense_cells = 160;  ///< contact sets up to this size are factorised; for larger ones Krylov is not slower
  /// Called after each step with the number of wrong cells. It may throw to stop the solve.
  std::function<void(std::size_t wrong)> after_step = {};
};

struct ActiveSetResult {
  enum class Outcome { solved, cycled, out_of_steps };

  Outcome outcome = Outcome::out_of_steps;
  // The set with the fewest wrong cells:
  CellSet contact;
  DiscreteState state;             ///< pressures clipped to p >= 0
  std::vector<std::size_t> wrong;  ///< cells under tension or penetrating; empty for a solution
  int steps = 0;
  int products = 0;
};

/// A primal-dual active-set method, which is Newton's method for min(p, g) = 0: it solves the equations of a contact
/// set, releases cells under tension and adds cells that penetrate, until there are none. [HIK03] `start` is the first
/// set, not empty. `guess` is the start of Krylov's method.
ActiveSetResult active_set(const DiscreteProblem& problem, CellSet start, const DiscreteState& guess,
                           const ActiveSetOptions& options);

/// The solution on one mesh.
struct MeshSolution {
  std::shared_ptr<const DiscreteProblem> problem;
  ActiveSetResult found;
  bool by_lemke = false;  ///< true if the active sets cycled and Lemke's method continued
};

struct NestedResult {
  MeshSolution fine;
  MeshSolution coarse;  ///< on half as many cells; the difference shows the error
  /// States on even coarser meshes, each half as fine as the one before; at most three.
  std::vector<DiscreteState> coarser;
  Certificate certificate;
};

/// Solves on nested meshes of equal cells of the frame, on the coarsest one from contact everywhere. The indenter is cut
/// at the frame's ends. Progress is reported after each step of the active sets, in proportion to the cost.
NestedResult solve_nested(const ContactProblem& problem, const Frame& frame, const VariationalOptions& options);
/// Solves on the whole support.
inline NestedResult solve_nested(const ContactProblem& problem, const VariationalOptions& options) {
  return solve_nested(problem, support_frame(problem), options);
}

/// Solves an already discretised problem, from a contact set that is not empty, and a state.
MeshSolution solve_on_cells(std::shared_ptr<const DiscreteProblem> problem, CellSet start, const DiscreteState& guess,
                            const ActiveSetOptions& options);

/// Returns a contact set on `cells` equal cells, from one on any other number of equal cells.
CellSet prolonged(const CellSet& set, std::size_t cells);

}  // namespace steadyslide::numeric::variational
