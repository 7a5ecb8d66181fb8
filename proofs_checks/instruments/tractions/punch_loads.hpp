#pragma once
// What the traction of a flat punch in full contact carries: integrals of the closed form over its panels, by the
// tanh-sinh rule. They know nothing of the surface beside the punch.

#include <vector>

#include "model/contact_problem.hpp"
#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

// (Not constrained: g++ 12 takes no constrained templates as template arguments.)
template <class R>
struct PunchLoads {
  std::vector<R> share;  ///< of the load, under each friction value
  R friction;            ///< effective coefficient: f by load
  R centre;              ///< of pressure, in the user's x
};

/// Throws std::logic_error unless the problem is a flat punch that keeps its attitude.
template <Real R>
PunchLoads<R> punch_loads(const ContactProblem& punch);

}  // namespace steadyslide::proofs_checks
