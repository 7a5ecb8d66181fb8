#pragma once
// Exact numbers. A datum of a problem is the rational that the user wrote: "0.1" is 1/10.

#ifdef STEADYSLIDE_DOUBLE_ONLY
#include <boost/multiprecision/cpp_int.hpp>
#else
#include <boost/multiprecision/gmp.hpp>
#endif
#include <string>
#include <string_view>

namespace steadyslide {

#ifdef STEADYSLIDE_DOUBLE_ONLY  // a build without GMP (bindings/explorer/CMakeLists.txt)
using IntegerBackend = boost::multiprecision::cpp_int_backend<>;
using RationalBackend = boost::multiprecision::cpp_rational_backend;
#else
using IntegerBackend = boost::multiprecision::gmp_int;
using RationalBackend = boost::multiprecision::gmp_rational;
#endif
using Integer = boost::multiprecision::number<IntegerBackend, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<RationalBackend, boost::multiprecision::et_off>;

/// Limits of a written number. They keep the cost of later exact computations bounded.
inline constexpr std::size_t max_number_length = 400;
inline constexpr int max_decimal_exponent = 400;

/// Reads `[+-]digits[.digits][e[+-]digits]`, or a quotient of two such numbers, exactly.
/// Throws InvalidData with an empty field if the text is not a number, is too long, or divides by zero.
Rational parse_rational(std::string_view text);

/// Returns the exact value: a decimal number if it is finite and short ("-0.25"), otherwise a fraction ("1/3").
std::string to_string(const Rational& value);

inline int sign(const Rational& value) { return value.sign(); }

}  // namespace steadyslide
