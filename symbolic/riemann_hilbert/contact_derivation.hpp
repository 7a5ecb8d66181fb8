#pragma once
// The steps from A t = psi' to t = epsilon cos(pi alpha) |Y| N on one contact, written with the expressions of the
// computation. Steps that are statements are decided exactly while they are written.

#include "symbolic/field/derivation.hpp"
#include "symbolic/field/formula_text.hpp"
#include "symbolic/local/polynomial_slope.hpp"
#include "symbolic/riemann_hilbert/riemann_hilbert.hpp"

namespace steadyslide::symbolic {

struct DerivationInput {
  FundamentalSolution solution;      ///< one component
  std::vector<GiNaC::ex> frictions;  ///< rational numbers
  std::vector<Formula> places;       ///< of the ends and jumps, as text for readers
  std::vector<GiNaC::ex> slope;      ///< psi', by coefficients of 1, x, ...
  GiNaC::ex load_over_pi;
};

/// Returns the derivation without a title. Throws std::domain_error if the contact and psi' admit no traction (N = 0).
Derivation derive(const DerivationInput& input);

}  // namespace steadyslide::symbolic
