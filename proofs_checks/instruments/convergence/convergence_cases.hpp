#pragma once
// The problems on which the cell solver is compared with the Riemann-Hilbert solution, and the rate at which it should
// converge to this solution.
//
// The cell solver is a Galerkin method with piecewise constants. Let a(t, v) = -<log * t, v>/pi + <int s t, v>. The
// error of a linear functional F is a(t - t_h, t* - v) for any piecewise constant v, where t* solves a(v, t*) = F(v).
// Close to a point with t ~ d^lambda and t* ~ d^lambda*, cells of length h contribute h^(lambda + lambda* + 2); a
// smooth part contributes h^3. The powers of the adjoint solution t* are those of -s on the same contact set, with one
// more condition at a friction jump: because of <int s v, t*> = <v, s int_x^1 t*>, the jump of s requires
// int_c^1 t* = 0, and a part of |x-c|^(-1-beta) in t* fulfils this. [Bal16, section 4]
//
//   edge, step       lambda* = edge exponent of -s                   sum -1, rate 1
//   free end         lambda* = edge exponent of -s: the contact set  sum  0, rate 2
//                    is the solution's; cells move the end by a part of a cell, and the effect is the square of this
//   friction jump    lambda* = -1 - beta                             sum -1, rate 1
//   wedge            log d, and t* smooth                            rate 3, with a logarithm
//
// The slowest rate in the contact is the rate of every resultant and of every intensity.

#include <span>

#include "numeric/variational/variational_solution.hpp"
#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

using numeric::VariationalSolution;

struct ConvergenceCase {
  std::string name;  ///< "jump-up"
  std::string what;  ///< a description in words
  ContactProblem problem;
};

/// Returns the problems. Friction jumps, wedges and steps divide the support in sevenths. Therefore seven consecutive
/// numbers of cells put them at seven different places within a cell.
std::vector<ConvergenceCase> convergence_cases();

/// Returns the problem with the friction values in the opposite order; with constant friction, the problem sliding in
/// the opposite direction.
ContactProblem with_friction_reversed(const ContactProblem& problem);

/// Returns lambda + lambda* + 2 at one singular point of the contact.
double local_rate(const ContactProblem& problem, const VariationalSolution::SingularPlace& place);

/// Returns the smallest local rate.
double expected_rate(const ContactProblem& problem, std::span<const VariationalSolution::SingularPlace> places);

}  // namespace steadyslide::proofs_checks
