#pragma once
// Is the solution known to be the only one? [Bal16, theorem 1 and theorem 8]

#include <string>

#include "model/contact_problem.hpp"

namespace steadyslide {

struct Uniqueness {
  bool proved = false;
  std::string reason;
};

/// Proved where s = +-gamma f nowhere decreases towards +x: the energy of [Bal16, section 4] is then positive. That is
/// "gamma f nondecreasing from rear to front" whichever way the indenter slides. Not covered otherwise, nor where the
/// indenter may tilt or its profile has a step: the theorem's profiles are Lipschitz-continuous.
Uniqueness uniqueness(const ContactProblem& problem);

}  // namespace steadyslide
