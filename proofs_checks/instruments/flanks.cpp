#include "proofs_checks/instruments/flanks.hpp"

namespace steadyslide::proofs_checks {

ContactProblem flanks(FrictionProfile friction, const Polynomial& left, const Polynomial& right, const Rational& load) {
  return {Elasticity(Solid(Rational(3, 10), 1)), std::move(friction),
          Indenter(-4, {{corner, left.composed(1, -corner)}, {4, right.composed(1, -corner)}}), load};
}

Rational wedge_of(const ContactProblem& problem) {
  const auto breaks = problem.indenter().breaks();
  return breaks.empty() ? Rational(0) : breaks.front().wedge / problem.elasticity().compliance();
}

}  // namespace steadyslide::proofs_checks
