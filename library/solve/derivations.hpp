#pragma once

#include <vector>

#include "model/contact_problem.hpp"
#include "symbolic/field/derivation.hpp"

namespace steadyslide::library {

/// Returns the derivation of each exponent of a problem and, if there is one, of its closed form.
std::vector<symbolic::Derivation> derivations(const ContactProblem& problem);

}  // namespace steadyslide::library
