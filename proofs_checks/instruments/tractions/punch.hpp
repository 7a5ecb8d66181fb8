#pragma once
// The flat punch in full contact under any number of friction jumps: random ones, and its traction
//
//   t = -(P cos(pi alpha(x))/pi) prod_j |x-e_j|^{p_j},   p = -(1/2+alpha_0), alpha_{k-1} - alpha_k, -(1/2-alpha_m),
//
// as a formula, with its check: A t = 0, the load, and the values of the closed forms. [Bal16, (4)-(7)]

#include "proofs_checks/instruments/tractions/power_product.hpp"
#include "proofs_checks/instruments/tractions/surface.hpp"
#include "proofs_checks/kit/cases.hpp"

namespace steadyslide::proofs_checks {

/// A flat punch on [-1, 1] in plane strain.
ContactProblem punch(const Rational& nu, std::vector<Rational> friction, std::vector<Rational> jumps = {},
                     const Rational& load = 1, Sliding sliding = Sliding::plus_x);

/// Random nu, friction and load, `jumps` friction jumps at random places.
ContactProblem random_punch(const Context& context, Random& random, std::size_t jumps);

/// m increasing places strictly inside ]-1, 1[.
std::vector<Rational> random_jumps(Random& random, std::size_t m);

/// Does the friction differ on the two sides of some jump?
bool has_jump(const ContactProblem& problem);

/// Is there friction anywhere?
bool has_friction(const ContactProblem& problem);

/// s of friction piece k for formulas, from the data alone: the indenter drags the body along, t_t = -f t where it moves
/// towards +x and f t where towards -x, and the surface's equation has -gamma t_t. What checks a formula asks the model for s:
/// a wrong sign there is no part of both.
Rational s_of(const ContactProblem& problem, std::size_t piece);
/// alpha = arctan(s)/pi of that s, and the amplitude load cos(pi alpha)/pi of the punch there.
Exponent alpha(const ContactProblem& problem, std::size_t piece);
template <Real R>
R punch_amplitude(const ContactProblem& problem, std::size_t piece) {
  return -to_real<R>(problem.load()) * cos_pi_alpha<R>(s_of(problem, piece)) / numeric::pi<R>();
}

/// The powers at the edges and jumps, from the angles on the pieces between them.
std::vector<Exponent> punch_powers(const std::vector<Exponent>& alpha);
/// alpha on every piece.
std::vector<Exponent> angles(const ContactProblem& problem);

/// A power at each point, an amplitude on each piece between them.
PowerProduct punch_traction(const ContactProblem& problem);

/// Against CLN's value of the same traction and the numeric layer's closed form, at points of every panel.
template <Real R>
void check_punch_values(Findings& findings, const PowerForm<R>& form, const ContactProblem& problem);

/// `tanh_sinh_points`: of the equation, by that rule.
template <Real R>
void check_punch_traction(Findings& findings, const PowerProduct& t, const ContactProblem& problem,
                          std::size_t tanh_sinh_points);

/// The largest random friction value: 50. In double 5: large values side by side make the traction vary over so many
/// orders of magnitude that rounding alone breaks the tolerance where it is small. (The grids go to 50 always.)
Rational largest_friction(const Context& context);

}  // namespace steadyslide::proofs_checks
