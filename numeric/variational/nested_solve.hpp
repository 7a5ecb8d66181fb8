#pragma once
// The discrete contact problem solved: by active sets on one mesh, and on a uniform mesh through coarser ones, each half as
// fine: the contact found on one is the next one's start.

#include <functional>
#include <optional>

#include "numeric/variational/bordered_system.hpp"
#include "numeric/variational/certificate.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::numeric::variational {

struct ActiveSetOptions {
  int most_steps = 100;
  int patience = 10;              ///< steps without a new lowest number of wrong cells: cycling, it is given up
  double tolerance = 1e-12;       ///< of the equations, relative to the profile's height where that exceeds c P
  double first_tolerance = 1e-5;  ///< as long as many cells are wrong
  std::size_t dense_cells = 160;  ///< contact sets up to this size are factorised: Krylov is no slower beyond
  /// Called after each step, with the number of cells that were wrong; may throw to end the solve.
  std::function<void(std::size_t wrong)> after_step = {};
};

struct ActiveSetResult {
  enum class Outcome { solved, cycled, out_of_steps };

  Outcome outcome = Outcome::out_of_steps;
  // Of the set with the fewest wrong cells:
  CellSet contact;
  DiscreteState state;             ///< pressures clipped to p >= 0
  std::vector<std::size_t> wrong;  ///< cells under tension or penetrating; none for a solution
  int steps = 0;
  int products = 0;
};

/// A primal-dual active set, Newton's method for min(p, g) = 0: solve the equations of a contact set, release its cells under
/// tension, take in the others that penetrate, until there are none. [HIK03] From the set `start`, which is not empty. `guess`: where Krylov's method begins.
ActiveSetResult active_set(const DiscreteProblem& problem, CellSet start, const DiscreteState& guess,
                           const ActiveSetOptions& options);

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
