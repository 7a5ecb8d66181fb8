#pragma once
// The problems on which the solver on cells is compared with the Riemann-Hilbert solution, and the rate at which it
// should converge to it.
//
// Piecewise constants, Galerkin: with a(t, v) = -<log * t, v>/pi + <int s t, v> the error of a linear functional F is
// a(t - t_h, t* - v) for any piecewise constant v, where t* solves a(v, t*) = F(v). Where t ~ d^lambda and t* ~
// d^lambda*, cells of length h next to the point contribute h^(lambda + lambda* + 2), a smooth part h^3. The adjoint's
// powers are those of s with the other sign on the contact as it is, with one more condition at a friction jump: as
// <int s v, t*> = <v, s int_x^1 t*>, the jump of s asks for int_c^1 t* = 0, and takes a part of |x-c|^(-1-beta) to meet
// it. [Bal16, section 4]
//
//   edge, step       lambda* = edge exponent of -s                   sum -1, rate 1
//   free end         lambda* = edge exponent of -s: the contact is   sum  0, rate 2
//                    the solution's; cells move the end by a part of a cell, with an effect of its square
//   friction jump    lambda* = -1 - beta                             sum -1, rate 1
//   wedge            log d, and t* smooth                            rate 3, with a logarithm
//
// The slowest of all that the contact has is the rate of every resultant and of every intensity.

#include <span>

#include "numeric/variational/variational_solution.hpp"
#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

using numeric::VariationalSolution;

struct ConvergenceCase {
  std::string name;  ///< "jump-up"
  std::string what;  ///< in words
  ContactProblem problem;
};

/// Jumps, wedges and steps divide the support in sevenths: seven consecutive numbers of cells put them at each of seven
/// places within a cell.
std::vector<ConvergenceCase> convergence_cases();

/// The friction values in the other order; a constant friction, sliding the other way.
ContactProblem with_friction_reversed(const ContactProblem& problem);

/// lambda + lambda* + 2 at one place of the contact.
double local_rate(const ContactProblem& problem, const VariationalSolution::SingularPlace& place);

/// The smallest of them.
double expected_rate(const ContactProblem& problem, std::span<const VariationalSolution::SingularPlace> places);

}  // namespace steadyslide::proofs_checks
