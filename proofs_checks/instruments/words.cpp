#include "proofs_checks/instruments/words.hpp"

#include "proofs_checks/claims/claims.hpp"

namespace steadyslide::proofs_checks {
namespace {

Polynomial around_corner(const Polynomial& p) {
  const Polynomial shift({-corner, 1});
  Polynomial result;
  for (int k = p.degree(); k >= 0; --k) {
    result = result * shift + Polynomial::constant(p.coefficient(static_cast<std::size_t>(k)));
  }
  return result;
}

}  // namespace

ContactProblem flanks(FrictionProfile friction, const Polynomial& left, const Polynomial& right, const Rational& load) {
  return {Elasticity(Solid(Rational(3, 10), 1)), std::move(friction),
          Indenter(-4, {{corner, around_corner(left)}, {4, around_corner(right)}}), load};
}

Rational wedge_of(const ContactProblem& problem) {
  for (const Indenter::Break& b : problem.indenter().breaks()) {
    if (b.x == corner) return b.wedge / problem.elasticity().compliance();
  }
  return 0;
}

std::vector<Claim> words_claims() { return {words_wedge(), words_jump(), words_wedge_and_jump(), step_conditions()}; }

}  // namespace steadyslide::proofs_checks
