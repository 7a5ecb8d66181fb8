#pragma once
// What the claims about flat punches share: their cases and the walk through them.

#include <string_view>
#include <vector>

#include "proofs_checks/instruments/surface.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {

using PunchFormula = Formula<PowerForm, ContactProblem>;

/// A flat punch on [-1, 1] in plane strain.
ContactProblem punch(const Rational& nu, std::vector<Rational> friction, std::vector<Rational> jumps = {},
                     const Rational& load = 1, Sliding sliding = Sliding::plus_x);

/// Random nu, friction and load, `jumps` friction jumps at random places.
ContactProblem random_punch(const Context& context, Random& random, std::size_t jumps);

struct Cases {
  std::vector<ContactProblem> problems;
  std::string detail;  ///< where they come from
};

/// `grid` (a part of it for a quick run), then `random` random punches with as many jumps as `jumps` says.
Cases punch_cases(const Context& context, std::string_view stream, std::vector<ContactProblem> grid, std::size_t random,
                  const std::function<std::size_t(Random&)>& jumps);

/// m increasing places strictly inside ]-1, 1[.
std::vector<Rational> random_jumps(Random& random, std::size_t m);

/// Does the friction differ on the two sides of some jump?
bool has_jump(const ContactProblem& problem);

/// Is there friction anywhere?
bool has_friction(const ContactProblem& problem);

/// alpha of friction piece k, and the amplitude load cos(pi alpha)/pi of the punch there.
Exponent alpha(const ContactProblem& problem, std::size_t piece);
template <Real R>
R punch_amplitude(const ContactProblem& problem, std::size_t piece) {
  return -numeric::to_real<R>(problem.load()) * numeric::cos_pi_alpha<R>(problem.coupled_friction(piece)) /
         numeric::pi<R>();
}

/// The traction under any number of jumps: a power at each point, an amplitude on each piece between them.
template <Real R>
PowerForm<R> punch_form(const ContactProblem& problem) {
  std::vector<Rational> points{problem.indenter().left()};
  std::vector<Exponent> exponents{-(half + alpha(problem, 0))};
  std::vector<R> amplitudes{punch_amplitude<R>(problem, 0)};
  const std::vector<Rational>& jumps = problem.friction().jumps();
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    points.push_back(jumps[k]);
    exponents.push_back(alpha(problem, k) - alpha(problem, k + 1));
    amplitudes.push_back(punch_amplitude<R>(problem, k + 1));
  }
  points.push_back(problem.indenter().right());
  exponents.push_back(-(half - alpha(problem, jumps.size())));
  return power_form<R>(points, std::move(exponents), std::move(amplitudes));
}

/// Against CLN's value of the same traction and the numeric layer's closed form, at points of every panel.
template <Real R>
void check_punch_values(Findings& findings, const PowerForm<R>& form, const ContactProblem& problem);

/// The largest random friction value: 50. In double 5: large values side by side make the traction vary over so many
/// orders of magnitude that rounding alone breaks the tolerance where it is small. (The grids go to 50 always.)
Rational largest_friction(const Context& context);

/// A number of cases or points by the number of digits; one in a quick run, but in double.
std::size_t count_for(const Context& context, std::size_t sixteen, std::size_t fifty, std::size_t hundred);

}  // namespace steadyslide::proofs_checks
