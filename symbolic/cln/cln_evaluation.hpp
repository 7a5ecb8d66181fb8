#pragma once
// The paper's constants to any number of digits, in CLN: a third arithmetic, unrelated to MPFR and to the numeric
// layer. Not thread-safe, as CLN is not.

#include "model/elasticity.hpp"
#include "model/exponent.hpp"
#include "symbolic/cln/decimal.hpp"

namespace steadyslide::symbolic {

/// `digits` correct significant digits of an exponent, also next to 0. Throws std::domain_error unless digits >= 1.
Decimal cln_value(const Exponent& exponent, int digits);

/// alpha = arctan(gamma f)/pi [Bal16, (4)], where gamma is that of a half-space under a rigid indenter: (1-2nu)/(2(1-nu)) in
/// plane strain [Bal16, section 2], (1-nu)/2 in plane stress. Throws std::domain_error unless -1 < nu < 1/2.
Decimal cln_alpha(const Rational& nu, const Rational& friction, Plane plane, int digits);

}  // namespace steadyslide::symbolic
