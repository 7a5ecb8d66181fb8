#pragma once
// Indenters of two flanks that meet at `corner`, polynomials in x - corner, over [-4, 4]; E = 1. They serve the claims
// about wedges in the contact. [Bal16, theorems 2, 9]

#include "model/contact_problem.hpp"

namespace steadyslide::proofs_checks {

inline const Rational corner{1, 8};

inline ContactProblem flanks(FrictionProfile friction, const Polynomial& left, const Polynomial& right,
                             const Rational& load, const Rational& nu = Rational(3, 10)) {
  return {Elasticity(Solid(nu, 1)), std::move(friction),
          Indenter(-4, {{corner, left.composed(1, -corner)}, {4, right.composed(1, -corner)}}), load};
}

/// Returns psi'(c+) - psi'(c-), reduced, at the profile's first break. Returns 0 if there is none.
inline Rational wedge_of(const ContactProblem& problem) {
  const std::vector<Indenter::Break>& breaks = problem.indenter().breaks();
  return breaks.empty() ? Rational(0) : breaks.front().wedge / problem.elasticity().compliance();
}

}  // namespace steadyslide::proofs_checks
