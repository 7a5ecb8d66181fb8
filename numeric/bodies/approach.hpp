#pragma once
// The approach delta of the indenter on a body with absolute displacements, such as layers on a rigid base: in contact
// u = psi + tilt x - delta, where u tends to 0 far from the contact. If a layer slips on the base, u tends to opposite
// constants on both sides under friction, and to 0 in the mean.

#include <optional>

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::numeric {

/// Returns delta; absent on other bodies, and without contact. It costs the making of the body's kernel.
std::optional<Estimate<double>> approach(const ContactProblem& problem, const ContactSolution<double>& solution);

}  // namespace steadyslide::numeric
