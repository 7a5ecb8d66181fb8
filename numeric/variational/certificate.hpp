#pragma once
// Is a state a solution of the discrete problem? Asked of the state alone, whoever found it.

#include "numeric/variational/discrete_problem.hpp"

namespace steadyslide::numeric::variational {

/// In units of P over the contact's length for pressures, and of c P for gaps.
struct Certificate {
  double natural = 0;   ///< max over cells of |min(p, g)|: zero for a complementary state and for nothing else
  double equation = 0;  ///< the largest |g| on the cells with p > 0
  double penetration = 0;
  double tension = 0;
  double load = 0;     ///< |sum p h - 1|
  double moment = 0;   ///< |sum p h xi - xi_load|, 0 without load_at
  double product = 0;  ///< B p by the operator against row sums of its entries, the largest difference; part of natural
  std::size_t rows = 0;  ///< rows summed: all of a small mesh, else those at the ends of contact, and others in between
  double allowed = 0;    ///< what all of the above have to stay below: 1e-10, more where the profile is high

  bool accepted() const;
};

Certificate certify(const DiscreteProblem& problem, const DiscreteState& state);

}  // namespace steadyslide::numeric::variational
