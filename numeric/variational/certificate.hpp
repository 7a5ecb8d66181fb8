#pragma once
// Checks whether a state solves the discrete problem, independently of the algorithm that found it.

#include "numeric/variational/discrete_problem.hpp"

namespace steadyslide::numeric::variational {

/// The residuals of a state. Pressures are in units of P over the contact's length, gaps in units of c P.
struct Certificate {
  double natural = 0;   ///< max over cells of |min(p, g)|: zero if and only if the state is complementary
  double equation = 0;  ///< the largest |g| on the cells with p > 0
  double penetration = 0;
  double tension = 0;
  double load = 0;       ///< |sum p h - 1|
  double moment = 0;     ///< |sum p h xi - xi_load|, 0 without load_at
  double product = 0;    ///< largest difference of B p by the operator and by row sums of its entries; part of natural
  std::size_t rows = 0;  ///< rows summed: all for a small mesh, otherwise those at the ends of contact and some others
  double allowed = 0;    ///< the limit for all of the above: 1e-10, larger if the profile is high

  bool accepted() const;
};

Certificate certify(const DiscreteProblem& problem, const DiscreteState& state);

}  // namespace steadyslide::numeric::variational
