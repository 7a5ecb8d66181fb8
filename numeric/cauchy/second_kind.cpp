#include "numeric/cauchy/second_kind.hpp"

#include <mpfr.h>

#include <boost/math/special_functions/digamma.hpp>

namespace steadyslide::numeric::second_kind {
namespace {

// Where series about one end of the interval cost as much as those about the other end or infinity.
constexpr double crossover = 0.6;

/// psi(c) + Euler's constant = -sum_k (1/(c+k) - 1/(1+k)).
template <Real R>
R digamma_plus_gamma(const R& c) {
  if constexpr (std::same_as<R, double>) {
    return boost::math::digamma(c) + 0.577215664901532861;
  } else {
    R psi;
    mpfr_digamma(psi.backend().data(), c.backend().data(), MPFR_RNDN);
    R gamma;
    mpfr_const_euler(gamma.backend().data(), MPFR_RNDN);
    return psi + gamma;
  }
}

/// sum_k z^k/(c+k), 0 <= z <= 5/8.
template <Real R>
R power_series(const R& c, const R& z) {
  R sum = 1 / c;
  R power = z;
  for (int k = 1; power > epsilon<R>() * sum * (c + k); ++k) {
    sum += power / (c + k);
    power *= z;
  }
  return sum;
}

/// sum_k (-d)^k/(c+k) by Euler's transformation, all terms positive: (1-v) sum_k k! v^k/(c (c+1) ... (c+k)),
/// v = d/(1+d). This is the sum without its factor, 0 <= v <= 5/8.
template <Real R>
R euler_series(const R& c, const R& v) {
  R term = 1 / c;
  R sum = term;
  for (int k = 1; term > epsilon<R>() * sum; ++k) {
    term *= k * v / (c + k);
    sum += term;
  }
  return sum;
}

/// int_0^r ((1-t)^-c - 1)/t dt = sum_k c (c+1) ... (c+k-1)/k! r^k/k, -1 < c < 2, 0 <= r <= 2/5.
template <Real R>
R binomial_series(const R& c, const R& r) {
  using std::abs;
  R term = c * r;
  R sum = term;
  for (int k = 2; abs(term) > epsilon<R>() * abs(sum); ++k) {
    term *= (c + (k - 1)) * r / k;
    sum += term / k;
  }
  return sum;
}

/// What follows is smooth through a = 0 and used for |a| <= 1/4: pi/sin(pi a) - 1/a.
template <Real R>
R cosecant_rest(const R& a) {
  using std::abs;
  const R square = pi<R>() * pi<R>() * a * a;
  // (x - sin x)/x^3 = 1/3! - x^2/5! + ...
  R term = R(1) / 6;
  R cubic = term;
  for (int k = 4; abs(term) > epsilon<R>() / 16; k += 2) {
    term *= -square / (k * (k + 1));
    cubic += term;
  }
  return pi<R>() * pi<R>() * a * cubic / (1 - square * cubic);
}

/// (x^a - 1)/a, log(x) at a = 0. A long exponent is left to the power function, which keeps its digits.
template <Real R>
R power_quotient(const R& a, const R& x) {
  using std::abs, std::expm1, std::log, std::pow;
  if (a == 0) return log(x);
  const R exponent = a * log(x);
  return (abs(exponent) < 1 ? expm1(exponent) : pow(x, a) - 1) / a;
}

/// x^a times f from whichever of a, 1 + a is smaller: the larger has lost what decides the power of a tiny x.
template <Real R>
R times_power(const R& f, const Power<R>& a, const R& x) {
  using std::pow;
  return a.plus_one < 0.5 ? f * pow(x, a.plus_one) / x : f * pow(x, a.value);
}

template <Real R>
bool near_zero(const R& a) {
  return a > -0.25 && a < 0.25;
}

template <Real R>
Power<R> one_less(const Power<R>& a) {
  return {a.value - 1, a.value};
}

}  // namespace

template <Real R>
R left_of(const Power<R>& a, const R& distance) {
  using std::sin;
  const R v = 1 / (1 + distance);
  if (distance >= crossover) return v * euler_series(a.plus_one, v);
  // y^a = y^(a-1) ((y + d) - d)
  if (a.value >= 0.25) return 1 / a.value - distance * left_of(one_less(a), distance);
  // pi d^a/sin(pi (1+a)) from the whole half-line, less what lies beyond 1: sum_k (-d)^k/(k-a).
  const R tail = distance * v * euler_series(1 - a.value, distance * v);
  if (!near_zero(a.value)) {
    const R whole = times_power(pi<R>() / sin(pi<R>() * a.plus_one), a, distance);
    return whole + (1 / a.value + tail);
  }
  const R quotient = power_quotient(a.value, distance);
  return tail - quotient - (1 + a.value * quotient) * cosecant_rest(a.value);
}

template <Real R>
R on_interval(const Power<R>& a, const R& x, const R& rest) {
  using std::log, std::tan;
  if (x >= crossover) {
    // y = x t: the integral of (t^a - 1)/(t - 1) up to t = 1 is psi(1+a) + gamma, from there to 1/x the series.
    const R bracket = digamma_plus_gamma(a.plus_one) + log(rest) + binomial_series(a.plus_one, rest);
    return times_power(bracket, a, x);
  }
  if (a.value >= 0.25) return 1 / a.value + x * on_interval(one_less(a), x, rest);
  // -pi cot(pi a) x^a from the whole half-line, less what lies beyond 1: sum_k x^k/(k-a).
  const R tail = x * power_series(1 - a.value, x);
  if (!near_zero(a.value)) {
    // The cotangent, with its zero at a = -1/2 exact.
    const R cotangent = a.plus_one < 0.25 ? 1 / tan(pi<R>() * a.plus_one) : tan(pi<R>() * (0.5 - a.plus_one));
    return times_power(-pi<R>() * cotangent, a, x) + (1 / a.value - tail);
  }
  const R quotient = power_quotient(a.value, x);
  const R cotangent_rest = cosecant_rest(a.value) - pi<R>() * tan(pi<R>() * a.value / 2);
  return -quotient - (1 + a.value * quotient) * cotangent_rest - tail;
}

template <Real R>
R right_of(const Power<R>& a, const R& distance) {
  using std::log, std::pow;
  const R w = 1 + distance;
  const R inverse = 1 / w;
  if (distance >= crossover) return inverse * power_series(a.plus_one, inverse);
  // y = (1+d) t: the integral of (1 - t^a)/(1 - t) up to t = 1 is psi(1+a) + gamma, from 1-v to there the series.
  const R v = distance * inverse;
  const R bracket = -digamma_plus_gamma(a.plus_one) - log(v) - binomial_series(-a.value, v);
  return bracket * pow(w, a.value);
}

#define STEADYSLIDE_INSTANTIATE(R)                                      \
  template R left_of(const Power<R>& a, const R& distance);             \
  template R on_interval(const Power<R>& a, const R& x, const R& rest); \
  template R right_of(const Power<R>& a, const R& distance);
STEADYSLIDE_INSTANTIATE(double)
STEADYSLIDE_INSTANTIATE(Real50)
STEADYSLIDE_INSTANTIATE(Real100)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric::second_kind
