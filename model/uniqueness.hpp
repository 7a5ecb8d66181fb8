#pragma once
// The theorems of docs/theory.md by which a solution is the only one.

#include <string>

#include "model/contact_problem.hpp"

namespace steadyslide {

/// Returns the theorem by which a solution of the problem is the only one, "uniqueness theorem for ...". Empty if none is
/// known: on layers and on given symbols where friction jumps.
std::string uniqueness_theorem(const ContactProblem& problem);

}  // namespace steadyslide
