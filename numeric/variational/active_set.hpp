#pragma once
// The discrete contact problem by a primal-dual active set, Newton's method for min(p, g) = 0: solve the equations of a
// contact set, release its cells under tension, take in the others that penetrate, until there are none.

#include <functional>

#include "numeric/variational/bordered_system.hpp"

namespace steadyslide::numeric::variational {

struct ActiveSetOptions {
  int most_steps = 100;
  double tolerance = 1e-12;       ///< of the equations, relative to the profile's height where that exceeds c P
  std::size_t dense_cells = 400;  ///< contact sets up to this size are factorised
  /// Called after each step, with the number of cells that were wrong; may throw to end the solve.
  std::function<void(std::size_t wrong)> after_step;
};

struct ActiveSetResult {
  enum class Outcome { solved, cycled, out_of_steps };

  Outcome outcome = Outcome::out_of_steps;
  CellSet contact;
  DiscreteState state;                 ///< pressures clipped to p >= 0
  std::vector<double> gaps;            ///< of the state before clipping
  std::size_t wrong = 0;               ///< cells under tension or penetrating, of the set returned: the best one met
  std::vector<std::size_t> contested;  ///< where the active sets did not end: the cells that changed in the last steps
  int steps = 0;
  int products = 0;
};

/// From the set `start`, which is not empty. `guess`: where Krylov's method begins.
ActiveSetResult active_set(const DiscreteProblem& problem, CellSet start, const DiscreteState& guess,
                           const ActiveSetOptions& options);

}  // namespace steadyslide::numeric::variational
