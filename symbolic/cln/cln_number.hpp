#pragma once
// Converts between the numbers of the model and those of CLN. For sources of this layer only, so that other layers do
// not include cln.h. CLN is not thread-safe. An operation on two floats has the precision of the less precise one; so
// one evaluation uses one format for all its floats.

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

#include "model/exponent.hpp"
#include "model/rational.hpp"

namespace steadyslide::symbolic {

/// Extra digits of the working precision, beyond the digits of the result.
inline constexpr int cln_guard_digits = 20;

cln::float_format_t cln_format(int digits);

cln::cl_RA to_cln(const Rational& value);
cln::cl_F to_cln(const Rational& value, cln::float_format_t format);
cln::cl_F power_of_ten(int exponent, cln::float_format_t format);
/// Returns the exact value of the float.
Rational from_cln(const cln::cl_F& value);

/// Returns the exponent to at least `digits` significant digits, also if its terms nearly cancel; 0 if and only if the
/// exponent is 0.
cln::cl_F to_cln(const Exponent& exponent, int digits);

/// Returns distance^power for distance > 0. Throws std::domain_error otherwise (CLN's logarithm of 0.0 does not
/// return).
cln::cl_F power(const cln::cl_F& distance, const cln::cl_F& exponent);

/// Returns cos(pi alpha) = 1/sqrt(1 + s^2), alpha = arctan(s)/pi. [Bal16, (4)]
cln::cl_F cos_pi_alpha(const Rational& s, cln::float_format_t format);

}  // namespace steadyslide::symbolic
