#pragma once
// The forces that the traction of a flat punch in full contact carries: integrals of the closed form over its panels,
// by the tanh-sinh rule. They do not use the surface outside of the punch.

#include <vector>

#include "model/contact_problem.hpp"
#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

// Not constrained, because g++ 12 does not accept constrained templates as template arguments.
template <class R>
struct PunchLoads {
  std::vector<R> share;  ///< load shares under each friction value
  R friction;            ///< effective coefficient of friction: mean of f, weighted with the load
  R centre;              ///< centre of pressure, in the user's x
};

/// Returns the loads. Throws std::logic_error unless the problem is a flat punch that keeps its attitude.
template <Real R>
PunchLoads<R> punch_loads(const ContactProblem& punch);

}  // namespace steadyslide::proofs_checks
