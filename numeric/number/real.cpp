#include "numeric/number/real.hpp"

#include <mpfr.h>

namespace steadyslide::numeric {
namespace {

/// A correctly rounded double: Boost's conversion of a rational truncates.
double nearest_double(const Rational& value) {
  mpfr_t rounded;
  mpfr_init2(rounded, 53);
  mpfr_set_q(rounded, value.backend().data(), MPFR_RNDN);
  const double result = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  return result;
}

template <class R>
bool touch_limits() {
  using std::isnan;
  using Limits = std::numeric_limits<R>;
  return Limits::epsilon() < Limits::round_error() && (Limits::min)() < (Limits::max)() &&
         (Limits::max)() < Limits::infinity() && isnan(Limits::quiet_NaN());
}

}  // namespace

bool make_limits() { return touch_limits<Real50>() && touch_limits<Real100>(); }

template <Real R>
R pi() {
  if constexpr (std::same_as<R, double>) {
    return 0x1.921fb54442d18p+1;
  } else {
    R value;
    mpfr_const_pi(value.backend().data(), MPFR_RNDN);
    return value;
  }
}

template <Real R>
R to_real(const Rational& value) {
  if constexpr (std::same_as<R, double>) {
    return nearest_double(value);
  } else {
    R result;
    mpfr_set_q(result.backend().data(), value.backend().data(), MPFR_RNDN);
    return result;
  }
}

template <Real R>
R to_real(const Exponent& exponent) {
  using std::atan;
  const Exponent::Reduced reduced = exponent.reduced();
  return to_real<R>(Rational(reduced.halves) / 2) + atan(to_real<R>(reduced.slope)) / pi<R>();
}

template <Real R>
R cos_pi_alpha(const Rational& s) {
  using std::sqrt;
  return 1 / sqrt(to_real<R>(1 + s * s));
}

template double pi();
template Real50 pi();
template Real100 pi();
template double to_real(const Rational&);
template Real50 to_real(const Rational&);
template Real100 to_real(const Rational&);
template double to_real(const Exponent&);
template Real50 to_real(const Exponent&);
template Real100 to_real(const Exponent&);
template double cos_pi_alpha(const Rational&);
template Real50 cos_pi_alpha(const Rational&);
template Real100 cos_pi_alpha(const Rational&);

}  // namespace steadyslide::numeric
