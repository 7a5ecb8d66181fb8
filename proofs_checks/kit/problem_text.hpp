#pragma once
// A contact problem as one line of text, which names it in evidence.

#include <string>

#include "model/contact_problem.hpp"

namespace steadyslide::proofs_checks {

/// Returns "nu = 3/10, f = 1/5, 3/5, jumps at 0, load 1, psi = x^2 on [-1, 1]".
std::string text_of(const ContactProblem& problem);

}  // namespace steadyslide::proofs_checks
