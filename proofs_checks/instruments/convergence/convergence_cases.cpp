#include "proofs_checks/instruments/convergence/convergence_cases.hpp"

#include <algorithm>

#include "proofs_checks/instruments/cells/cells.hpp"

namespace steadyslide::proofs_checks {
namespace {

ContactProblem reduced(std::vector<Rational> s, std::vector<Rational> jumps, Indenter indenter, const Rational& load,
                       const std::optional<Rational>& load_at = std::nullopt) {
  return cell_problem({std::move(s), std::move(jumps)}, Polynomial(), load, load_at).with_indenter(std::move(indenter));
}

Indenter one_piece(const Rational& half_length, Polynomial profile) {
  return {-half_length, {{half_length, std::move(profile)}}};
}

}  // namespace

std::vector<ConvergenceCase> convergence_cases() {
  const Rational low(1, 10);
  const Rational middle(3, 10);
  const Rational high(3, 5);
  const Rational c(-1, 7);
  const Indenter flat = one_piece(1, Polynomial());
  const Indenter parabola = one_piece(1, Polynomial({0, 0, Rational(1, 2)}));
  const Indenter two_bumps = one_piece(Rational(7, 4), Polynomial({1, Rational(1, 10), -2, 0, 1}));
  const Indenter wedge(-1, {{c, Polynomial({Rational(-1, 28), Rational(-1, 4), Rational(1, 2)})},
                            {1, Polynomial({Rational(1, 28), Rational(1, 4), Rational(1, 2)})}});
  const Indenter step(-1, {{Rational(-3, 7), Polynomial({Rational(1, 5), 0, Rational(1, 4)})},
                           {1, Polynomial({0, 0, Rational(1, 4)})}});
  return {
      {"jump-up", "a parabola over a friction jump up, both ends free", reduced({low, high}, {c}, parabola, 1)},
      {"jump-down", "a parabola over a friction jump down, both ends free",
       reduced({high, low}, {c}, parabola, Rational(1, 2))},
      {"wedge", "a blunt wedge, both ends free", reduced({middle}, {}, wedge, 1)},
      {"wedge-and-jump", "a blunt wedge with its vertex on a friction jump, both ends free",
       reduced({low, high}, {c}, wedge, 1)},
      {"tilted-punch", "a flat punch that may tilt, over a friction jump",
       reduced({Rational(1, 5), Rational(2, 5)}, {c}, flat, 1, Rational(1, 10))},
      {"two-zones", "two bumps, all four ends free", reduced({middle}, {}, two_bumps, 2)},
      {"step", "a parabola with a step, one end of the contact at it, the other free",
       reduced({middle}, {}, step, Rational(1, 5))},
      {"three-jumps", "a flat punch over three friction jumps",
       reduced({low, Rational(2, 5), 0, Rational(1, 5)}, {Rational(-3, 7), Rational(1, 7), Rational(5, 7)}, flat, 1)}};
}

ContactProblem with_friction_reversed(const ContactProblem& problem) {
  std::vector<Rational> values = problem.friction().values();
  std::reverse(values.begin(), values.end());
  const bool constant = values == problem.friction().values();
  return problem.with_friction(FrictionProfile(std::move(values), problem.friction().jumps()))
      .with_sliding(constant ? Sliding::minus_x : problem.sliding());
}

double local_rate(const ContactProblem& problem, const VariationalSolution::SingularPlace& place) {
  if (!place.exponent || place.exponent->sign() == 0) return 3;
  const Rational left = problem.coupled_friction(place.friction_left);
  const Rational right = problem.coupled_friction(place.friction_right);
  const Exponent adjoint =
      place.is_end() ? edge_exponent(opposite(place.contact), -left) : jump_exponent(-left, -right) - Exponent(1);
  return to_real<double>(*place.exponent + adjoint + Exponent(2));
}

double expected_rate(const ContactProblem& problem, std::span<const VariationalSolution::SingularPlace> places) {
  double rate = 3;
  for (const auto& place : places) rate = std::min(rate, local_rate(problem, place));
  return rate;
}

}  // namespace steadyslide::proofs_checks
