#pragma once
// The local forms of one problem as derivations for readers, one for each place where the traction can be singular.
// This header does not include GiNaC. Not thread-safe, because GiNaC is not.

#include <vector>

#include "model/contact_problem.hpp"
#include "symbolic/field/derivation.hpp"

namespace steadyslide::symbolic {

/// Returns one derivation for each of possible_singular_points(problem), in that order, with the problem's s and the
/// reduced slope psi_bar' at the place, up to its second derivative.
std::vector<Derivation> local_derivations(const ContactProblem& problem);

}  // namespace steadyslide::symbolic
