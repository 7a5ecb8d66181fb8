#pragma once
// Problems on cells for tests.

#include "numeric/variational/bordered_system.hpp"
#include "support/problems.hpp"
#include "support/random_contact.hpp"

namespace steadyslide::testing {

using namespace numeric::variational;

inline DiscreteProblem on_cells(const ContactProblem& problem, std::size_t cells) {
  return {problem, CellMesh(problem, cells)};
}

/// Returns problem k of the list by which solvers are measured.
inline ContactProblem listed_contact(std::uint64_t k) { return random_contact(first_listed_seed + k); }

/// The state without pressure.
inline DiscreteState nothing(const DiscreteProblem& problem) { return {std::vector<double>(problem.size(), 0.0)}; }

struct Forces {
  double load = 0, moment = 0;
  double size = 0;  ///< the sum of |pressure times length|
};

inline Forces forces_of(const DiscreteProblem& problem, const DiscreteState& state) {
  Forces sum;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const double q = state.pressure[i] * problem.mesh().length(i);
    sum = {sum.load + q, sum.moment + q * problem.mesh().centre(i), sum.size + std::abs(q)};
  }
  return sum;
}

/// Returns all nonempty sets of cells.
inline std::vector<CellSet> all_sets(std::size_t cells) {
  std::vector<CellSet> sets;
  for (unsigned bits = 1; bits < 1U << cells; ++bits) {
    CellSet& set = sets.emplace_back(cells);
    for (unsigned i = 0; i < cells; ++i) set[i] = static_cast<char>(bits >> i & 1U);
  }
  return sets;
}

}  // namespace steadyslide::testing
