#pragma once
// The sentences after theorems 2 and 3 as claims, and the problems they share. [Bal16, theorems 2, 3]

#include "proofs_checks/instruments/near.hpp"

namespace steadyslide::proofs_checks {

Claim words_wedge();
Claim words_jump();
Claim words_wedge_and_jump();
Claim step_conditions();

/// Two flanks that meet at `corner`, polynomials in x - corner, over [-4, 4]; nu = 3/10, E = 1.
inline const Rational corner{1, 8};
ContactProblem flanks(FrictionProfile friction, const Polynomial& left, const Polynomial& right, const Rational& load);

/// psi'(c+) - psi'(c-), reduced.
Rational wedge_of(const ContactProblem& problem);

}  // namespace steadyslide::proofs_checks
