#pragma once
// The closed set of numbers that the numeric kernels are compiled for, and the one door from run time to type.

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

// Those of double. The MPFR numbers have theirs beside them, where an unqualified call finds them.
using std::abs, std::asinh, std::atan, std::atan2, std::ceil, std::cos, std::cosh, std::exp, std::expm1, std::floor,
    std::isfinite, std::isinf, std::isnan, std::ldexp, std::log, std::log1p, std::max, std::min, std::pow, std::sin,
    std::sinh, std::sqrt, std::tan;

#ifdef STEADYSLIDE_DOUBLE_ONLY

// A build for where there is no MPFR (explorer/CMakeLists.txt): names of numbers that it does not have.
class Real50;
class Real100;

#define STEADYSLIDE_FOR_EACH_REAL(X) X(double)
#define STEADYSLIDE_INSTANTIATE_CLASS(Name) template class Name<double>;

#else

// Statically sized MPFR numbers: no global default precision exists that could leak. 57 and 114 decimal digits fill
// three and six limbs: the digits beyond 50 and 100 are guard digits that cost nothing. Chosen by measurement against
// cpp_bin_float of the same size (bench/README.md).
using Real50 =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<57, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;
using Real100 =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<114, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// Boost 1.74 makes the limits of an MPFR number when they are first asked for, without a lock (before main(), but for
/// the number with the other kind of expressions): here all are made before a second thread can ask.
bool make_limits();
inline const bool limits_are_made = make_limits();

/// X(R) for each number R: what is compiled, where templates are defined.
#define STEADYSLIDE_FOR_EACH_REAL(X) X(double) X(Real50) X(Real100)

/// Compiles the class template Name for each of them.
#define STEADYSLIDE_INSTANTIATE_CLASS(Name) \
  template class Name<double>;              \
  template class Name<Real50>;              \
  template class Name<Real100>;

#endif

template <class R>
concept Real = std::same_as<R, double> || std::same_as<R, Real50> || std::same_as<R, Real100>;

/// The digits that results at a precision are served with.
enum class Digits { sixteen = 16, fifty = 50, hundred = 100 };

/// The smallest precision that serves `digits` significant digits. Throws std::out_of_range unless 1 <= digits <= 100.
inline Digits precision_for(int digits) {
  if (digits < 1 || digits > 100) throw std::out_of_range("digits");
  return digits <= 16 ? Digits::sixteen : digits <= 50 ? Digits::fifty : Digits::hundred;
}

#ifndef STEADYSLIDE_DOUBLE_ONLY
/// Calls f.operator()<R>() with the type that serves `digits`.
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

/// The distance from 1 to the next number.
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

/// The nearest number of the type. Values beyond the range of double become infinite or zero.
template <Real R>
R to_real(const Rational& value);

/// The exponent to full relative precision, also next to 0, from its reduced form: nothing cancels.
template <Real R>
R to_real(const Exponent& exponent);

/// cos(pi alpha) = 1/sqrt(1 + s^2), the angle alpha of s. [Bal16, (4)]
template <Real R>
R cos_pi_alpha(const Rational& s);

}  // namespace steadyslide::numeric
