#include "model/uniqueness.hpp"

namespace steadyslide {

Uniqueness uniqueness(const ContactProblem& problem) {
  if (problem.load_at()) return {false, "the indenter may tilt, which the theorem does not cover"};
  const std::vector<Rational>& jumps = problem.friction().jumps();
  bool constant = true;
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    const Rational left = problem.coupled_friction(k);
    const Rational right = problem.coupled_friction(k + 1);
    if (right < left) return {false, "s = gamma f decreases towards the front at x = " + to_string(jumps[k])};
    constant = constant && left == right;
  }
  for (const Indenter::Break& at : problem.indenter().breaks()) {
    if (at.step != 0)
      return {false, "the profile has a step at x = " + to_string(at.x) + ", which the theorem excludes"};
  }
  if (constant) return {true, "s = gamma f is constant"};
  return {true, "s = gamma f is nondecreasing towards the front"};
}

}  // namespace steadyslide
