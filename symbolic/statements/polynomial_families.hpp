#pragma once
// Polynomials in one symbol for exact integration: antiderivatives, and Chebyshev's polynomials.

#include <ginac/ginac.h>

#include <vector>

namespace steadyslide::symbolic {

/// Returns the antiderivative of a polynomial in x that is 0 at x = 0.
GiNaC::ex antiderivative(const GiNaC::ex& polynomial, const GiNaC::symbol& x);
GiNaC::ex integral(const GiNaC::ex& polynomial, const GiNaC::symbol& x, const GiNaC::ex& from, const GiNaC::ex& to);
/// Return T_n and, for n >= -1, U_n (U_{-1} = 0), by their recurrence.
GiNaC::ex chebyshev_t(int n, const GiNaC::ex& x);
GiNaC::ex chebyshev_u(int n, const GiNaC::ex& x);

}  // namespace steadyslide::symbolic
