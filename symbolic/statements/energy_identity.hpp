#pragma once
// The energy of a traction t of zero mean, with T(x) = int_{-1}^x t and friction s_0, s_1, ... between jumps c_k:
//
//   b(t, t) = -(1/pi) <t*log|x|, t> + <int_{-1}^x s t, t> = -(1/pi) <t*log|x|, t> + 1/2 sum_k (s_k - s_{k-1}) T(c_k)^2.
//
// By parts <int s t, t> = -int s t T, and t T = (T^2)'/2: nothing is left but the jumps of s. Decided exactly for
// families of t with symbolic coefficients and jump places: piecewise polynomials, and polynomials over sqrt(1-x^2),
// for which the logarithmic form is (pi/2) sum a_n^2/n. [Bal16, section 3.1] Without GiNaC in this header. Not
// thread-safe, as GiNaC is not.

#include "symbolic/statements/exact_identities.hpp"

namespace steadyslide::symbolic {

std::vector<DecidedStatement> energy_statements();

}  // namespace steadyslide::symbolic
