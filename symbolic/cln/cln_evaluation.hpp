#pragma once
// The paper's constants to any number of digits, in CLN. CLN is independent of MPFR and of the numeric layer. Not
// thread-safe, because CLN is not.

#include "model/elasticity.hpp"
#include "model/exponent.hpp"
#include "symbolic/cln/decimal.hpp"

namespace steadyslide::symbolic {

/// Returns `digits` correct significant digits of an exponent, also if it is close to 0. Throws std::domain_error
/// unless digits >= 1.
Decimal cln_value(const Exponent& exponent, int digits);

/// Returns alpha = arctan(gamma f)/pi [Bal16, (4)], with gamma of a half-space under a rigid indenter: (1-2nu)/(2(1-nu)) in
/// plane strain [Bal16, section 2], (1-nu)/2 in plane stress. Throws std::domain_error unless -1 < nu < 1/2.
Decimal cln_alpha(const Rational& nu, const Rational& friction, Plane plane, int digits);

}  // namespace steadyslide::symbolic
