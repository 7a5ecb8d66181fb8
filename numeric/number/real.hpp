#pragma once
// The number types for which the numeric kernels are compiled, and the only function that selects a type at run time.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <stdexcept>

#include "model/exponent.hpp"
#include "model/rational.hpp"
#ifndef STEADYSLIDE_DOUBLE_ONLY
#include "numeric/number/elementary.hpp"
#endif

namespace steadyslide::numeric {

// The functions for double. Those for MPFR numbers are in the namespace of these numbers, where an unqualified call
// finds them.
using std::abs, std::asinh, std::atan, std::atan2, std::ceil, std::cos, std::cosh, std::exp, std::expm1, std::floor,
    std::isfinite, std::isinf, std::isnan, std::ldexp, std::log, std::log1p, std::max, std::min, std::pow, std::sin,
    std::sinh, std::sqrt, std::tan;

#ifdef STEADYSLIDE_DOUBLE_ONLY

// A build without MPFR (bindings/explorer/CMakeLists.txt) only declares the names of these types.
class Real50;
class Real100;

#define STEADYSLIDE_FOR_EACH_REAL(X) X(double)
#define STEADYSLIDE_INSTANTIATE_CLASS(Name) template class Name<double>;

#else

// MPFR numbers of fixed size, so that there is no global default precision. 57 and 114 decimal digits fill three and
// six limbs; the digits beyond 50 and 100 are guard digits without extra cost. They were chosen by measurement against
// cpp_bin_float of the same size (tests/bench/README.md).
using Real50 =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<57, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;
using Real100 =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<114, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// Computes all limits of MPFR numbers before a second thread can use them. Boost 1.74 computes them at first use
/// without a lock (before main(), except for the number type with the other kind of expressions).
bool make_limits();
inline const bool limits_are_made = make_limits();

/// Expands to X(R) for each number type R. Used where templates are defined, to compile them.
#define STEADYSLIDE_FOR_EACH_REAL(X) X(double) X(Real50) X(Real100)

/// Compiles the class template Name for each number type.
#define STEADYSLIDE_INSTANTIATE_CLASS(Name) \
  template class Name<double>;              \
  template class Name<Real50>;              \
  template class Name<Real100>;

#endif

template <class R>
concept Real = std::same_as<R, double> || std::same_as<R, Real50> || std::same_as<R, Real100>;

/// The number of digits of the results at a precision.
enum class Digits { sixteen = 16, fifty = 50, hundred = 100 };

/// Returns the smallest precision for `digits` significant digits. Throws std::out_of_range unless 1 <= digits <= 100.
inline Digits precision_for(int digits) {
  if (digits < 1 || digits > 100) throw std::out_of_range("digits");
  return digits <= 16 ? Digits::sixteen : digits <= 50 ? Digits::fifty : Digits::hundred;
}

#ifndef STEADYSLIDE_DOUBLE_ONLY
/// Calls f.operator()<R>() with the number type for `digits`.
template <class F>
decltype(auto) at_precision(Digits digits, F&& f) {
  switch (digits) {
    case Digits::sixteen: return f.template operator()<double>();
    case Digits::fifty: return f.template operator()<Real50>();
    default: return f.template operator()<Real100>();
  }
}
#endif

template <Real R>
inline constexpr int digits_served = std::same_as<R, double>   ? 16
                                     : std::same_as<R, Real50> ? 50
                                                               : 100;

template <Real R>
inline constexpr Digits digits_of = static_cast<Digits>(digits_served<R>);

/// Returns the distance from 1 to the next number.
template <Real R>
R epsilon() {
  return std::numeric_limits<R>::epsilon();
}

template <Real R>
R infinity() {
  return std::numeric_limits<R>::infinity();
}

template <Real R>
R pi();

/// Returns the nearest number of the type. Values out of the range of double become infinite or zero.
template <Real R>
R to_real(const Rational& value);

/// Returns the exponent to full relative precision, also close to 0. It uses the reduced form, in which nothing
/// cancels.
template <Real R>
R to_real(const Exponent& exponent);

/// Returns cos(pi alpha) = 1/sqrt(1 + s^2) for the angle alpha of s. [Bal16, (4)]
template <Real R>
R cos_pi_alpha(const Rational& s);

}  // namespace steadyslide::numeric
