#pragma once
// The discrete contact problem by a primal-dual active set, Newton's method for min(p, g) = 0: solve the equations of a
// contact set, release its cells under tension, take in the others that penetrate, until there are none. [HIK03]

#include <functional>

#include "numeric/variational/bordered_system.hpp"

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

/// From the set `start`, which is not empty. `guess`: where Krylov's method begins.
ActiveSetResult active_set(const DiscreteProblem& problem, CellSet start, const DiscreteState& guess,
                           const ActiveSetOptions& options);

}  // namespace steadyslide::numeric::variational
