#pragma once
// The traction of the flat punch in full contact under any number of friction jumps,
//
//   t = -(P cos(pi alpha(x))/pi) prod_j |x-e_j|^{p_j},   p = -(1/2+alpha_0), alpha_{k-1} - alpha_k, -(1/2-alpha_m),
//
// as a formula, and its check: A t = 0, the load, and the values of the closed forms. [Bal16, (4)-(7)]

#include "proofs_checks/instruments/power_product.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {

PowerProduct punch_traction(const ContactProblem& problem);

/// `tanh_sinh_points`: of the equation, by that rule.
template <Real R>
void check_punch_traction(Findings& findings, const PowerProduct& t, const ContactProblem& problem,
                          std::size_t tanh_sinh_points);

}  // namespace steadyslide::proofs_checks
