#include "proofs_checks/instruments/solutions/falling_contacts.hpp"

#include <algorithm>

#include "proofs_checks/instruments/cells/cells.hpp"

namespace steadyslide::proofs_checks {

ContactProblem with_profile_plus(const ContactProblem& problem, const Polynomial& polynomial) {
  std::vector<Indenter::Piece> pieces = problem.indenter().pieces();
  for (Indenter::Piece& piece : pieces) piece.profile = piece.profile + polynomial;
  return problem.with_indenter(Indenter(problem.indenter().left(), std::move(pieces)));
}

ContactProblem with_load_at(const ContactProblem& problem, std::optional<Rational> load_at) {
  return {problem.elasticity(), problem.friction(), problem.indenter(),
          problem.load(),       problem.sliding(),  std::move(load_at)};
}

Rational usual_slope(const ContactProblem& problem) {
  const Indenter& indenter = problem.indenter();
  return problem.elasticity().compliance() * problem.load() / (indenter.right() - indenter.left());
}

ContactProblem random_falling_contact(Random& random, std::size_t k) {
  CellFrictionSteps steps = random_steps(random, random.below(5) == 0 ? Trend::any : Trend::falling, 5, 3);
  if (random.below(2) == 0) steps = mirrored(steps);
  const auto from = [](const Rational& c, const Rational& height, const Rational& slope, const Rational& curve) {
    return Polynomial({height, slope, curve}).composed(1, -c);
  };
  const Rational left = random.between(Rational(1, 8), 1), right = random.between(Rational(1, 8), 1);
  const Rational curve = random.between(Rational(1, 8), 1);
  Rational c = random.between(Rational(-1, 2), Rational(1, 2));
  std::vector<Indenter::Piece> pieces;
  switch (k % 5) {
    case 0: pieces = {{1, random_profile(random, random.below(2) == 0)}}; break;
    case 1: pieces = {{c, from(c, 0, -left, curve)}, {1, from(c, 0, right, curve)}}; break;
    case 2: {
      const Rational notch = c + random.between(0, Rational(1, 3));
      const Rational beyond = right * random.between(-1, Rational(7, 8));
      pieces = {{c, from(c, 0, -left, 0)},
                {notch, from(c, 0, right, 0)},
                {1, from(notch, right * (notch - c), beyond, curve)}};
      c = notch;
      break;
    }
    case 3: {
      const bool rises = random.below(2) == 0;
      const Rational step = left / 4;
      pieces = {{c, Polynomial({rises ? Rational(0) : step, 0, curve})},
                {1, Polynomial({rises ? step : Rational(0), 0, curve})}};
      break;
    }
    default:
      c = 0;
      pieces = {{0, from(Rational(-1, 2), 0, 0, 4)}, {1, from(Rational(1, 2), left / 8, 0, 4 - left / 2)}};
      break;
  }
  // Friction often jumps where the profile breaks.
  if (random.below(3) == 0 && std::ranges::find(steps.jumps, c) == steps.jumps.end()) {
    steps.jumps[random.below(steps.jumps.size())] = c;
    std::ranges::sort(steps.jumps);
  }
  return cell_problem(steps, Polynomial(), random.between(Rational(1, 50), 3)).with_indenter(Indenter(-1, pieces));
}

ContactProblem tilting_bumps() {
  return cell_problem({{0, 0}, {0}}, Polynomial({0, 0, Rational(-9, 10), 0, 1}), Rational(13, 10), Rational(5, 8));
}

}  // namespace steadyslide::proofs_checks
