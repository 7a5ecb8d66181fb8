#pragma once
// Uniqueness of the solution, as far as it is proved. [Bal16, theorem 1 and theorem 8]

#include <string>

#include "model/contact_problem.hpp"

namespace steadyslide {

struct Uniqueness {
  bool proved = false;
  std::string reason;
};

/// Uniqueness is proved if s = +-gamma f nowhere decreases towards +x: then the energy of [Bal16, section 4] is
/// positive. For both directions of sliding this is "gamma f nondecreasing from rear to front". It is not proved
/// otherwise, and not if the indenter may tilt or its profile has a step: the profiles of the theorem are
/// Lipschitz-continuous.
Uniqueness uniqueness(const ContactProblem& problem);

}  // namespace steadyslide
