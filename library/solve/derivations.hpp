#pragma once

#include <vector>

#include "model/contact_problem.hpp"
#include "symbolic/field/derivation.hpp"

namespace steadyslide::library {

/// How each exponent of a problem comes about and, where there is one, its closed form.
std::vector<symbolic::Derivation> derivations(const ContactProblem& problem);

}  // namespace steadyslide::library
