#pragma once
// Indenters of two flanks that meet at `corner`, polynomials in x - corner, over [-4, 4]; nu = 3/10, E = 1. On them the
// sentences after theorem 2 are examined. [Bal16, theorem 2]

#include "model/contact_problem.hpp"

namespace steadyslide::proofs_checks {

inline const Rational corner{1, 8};
ContactProblem flanks(FrictionProfile friction, const Polynomial& left, const Polynomial& right, const Rational& load);

/// psi'(c+) - psi'(c-) of the first break of a profile, reduced; 0 where there is none.
Rational wedge_of(const ContactProblem& problem);

}  // namespace steadyslide::proofs_checks
