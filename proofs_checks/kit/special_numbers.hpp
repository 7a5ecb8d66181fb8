#pragma once
// Special numbers of formulas, computed by MPFR. Boost.Math's functions have tables that the program would compute at
// every start.

#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

/// Returns Gamma'(x)/Gamma(x).
inline Number digamma(const Number& x) {
  Number value;
  mpfr_digamma(value.backend().data(), x.backend().data(), MPFR_RNDN);
  return value;
}

/// Returns 1 - 1/9 + 1/25 - 1/49 + ...
inline Number catalan() {
  Number value;
  mpfr_const_catalan(value.backend().data(), MPFR_RNDN);
  return value;
}

}  // namespace steadyslide::proofs_checks
