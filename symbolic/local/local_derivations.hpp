#pragma once
// The local forms of one problem, as derivations to read: one for every place where the traction can be singular.
// Without GiNaC in this header. Not thread-safe, as GiNaC is not.

#include <vector>

#include "model/contact_problem.hpp"
#include "symbolic/field/derivation.hpp"

namespace steadyslide::symbolic {

/// One derivation for each of possible_singular_points(problem), in that order, with the problem's s and the reduced
/// slopes psi_bar' at the place (to the second derivative of psi_bar').
std::vector<Derivation> local_derivations(const ContactProblem& problem);

}  // namespace steadyslide::symbolic
