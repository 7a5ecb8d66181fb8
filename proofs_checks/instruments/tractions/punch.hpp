#pragma once
// The flat punch in full contact with any number of friction jumps: random punches, and the formula for the traction
//
//   t = -(P cos(pi alpha(x))/pi) prod_j |x-e_j|^{p_j},   p = -(1/2+alpha_0), alpha_{k-1} - alpha_k, -(1/2-alpha_m),
//
// with its check: A t = 0, the load, and the values of the closed forms. [Bal16, (4)-(7)]

#include "proofs_checks/instruments/tractions/power_product.hpp"
#include "proofs_checks/instruments/tractions/surface.hpp"
#include "proofs_checks/kit/cases.hpp"

namespace steadyslide::proofs_checks {

/// Returns a flat punch on [-1, 1] in plane strain.
ContactProblem punch(const Rational& nu, std::vector<Rational> friction, std::vector<Rational> jumps = {},
                     const Rational& load = 1, Sliding sliding = Sliding::plus_x);

/// Returns a punch with random nu, friction and load, and with `jumps` friction jumps at random points.
ContactProblem random_punch(const Context& context, Random& random, std::size_t jumps);

/// Returns m increasing points inside ]-1, 1[.
std::vector<Rational> random_jumps(Random& random, std::size_t m);

/// True if the friction differs on the two sides of some jump.
bool has_jump(const ContactProblem& problem);

/// True if there is friction on some piece.
bool has_friction(const ContactProblem& problem);

/// Returns s of friction piece k for formulas, from the data alone. The indenter drags the body along: t_t = -f t if it
/// slides towards +x, and f t if towards -x. The surface's equation contains -gamma t_t. The checks of a formula take s
/// from the model instead, so that a wrong sign cannot be in both.
Rational s_of(const ContactProblem& problem, std::size_t piece);
/// Return alpha = arctan(s)/pi for this s, and the punch's amplitude -P cos(pi alpha)/pi there.
Exponent alpha(const ContactProblem& problem, std::size_t piece);
template <Real R>
R punch_amplitude(const ContactProblem& problem, std::size_t piece) {
  return -to_real<R>(problem.load()) * cos_pi_alpha<R>(s_of(problem, piece)) / numeric::pi<R>();
}

/// Returns the powers at the edges and friction jumps, from the angles on the pieces between them.
std::vector<Exponent> punch_powers(const std::vector<Exponent>& alpha);
/// Returns alpha on every piece.
std::vector<Exponent> angles(const ContactProblem& problem);

/// Returns the formula: a power at each point, and an amplitude on each piece between points.
PowerProduct punch_traction(const ContactProblem& problem);

/// Compares with the derived contact in CLN and with the numeric layer's closed form, at points of every panel.
template <Real R>
void check_punch_values(Findings& findings, const PowerForm<R>& form, const ContactProblem& problem);

/// Checks the traction. `tanh_sinh_points` is the number of points at which the tanh-sinh rule checks the equation.
template <Real R>
void check_punch_traction(Findings& findings, const PowerProduct& t, const ContactProblem& problem,
                          std::size_t tanh_sinh_points);

/// Returns the largest random friction value: 50, or 5 in double. With large values side by side the traction varies
/// over so many orders of magnitude that rounding alone exceeds the tolerance where it is small. (The fixed cases
/// always go up to 50.)
Rational largest_friction(const Context& context);

}  // namespace steadyslide::proofs_checks
