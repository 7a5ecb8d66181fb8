#include "numeric/cauchy/second_kind.hpp"

namespace steadyslide::numeric::second_kind {
namespace {

// The distance at which the series about the end of the interval and those about infinity cost the same.
constexpr double crossover = 0.6;

/// sum_k (-d)^k/(c+k) by Euler's transformation, all terms positive: (1-v) sum_k k! v^k/(c (c+1) ... (c+k)),
/// v = d/(1+d). Returns the sum without its factor (1-v), for 0 <= v <= 5/8.
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

/// Returns pi/sin(pi a) - 1/a, which is smooth at a = 0. Used for |a| <= 1/4.
template <Real R>
R cosecant_rest(const R& a) {
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

/// Returns (x^a - 1)/a; log(x) for a = 0. For a large exponent it calls the power function, which keeps the digits.
template <Real R>
R power_quotient(const R& a, const R& x) {
  if (a == 0) return log(x);
  const R exponent = a * log(x);
  return (abs(exponent) < 1 ? expm1(exponent) : pow(x, a) - 1) / a;
}

/// Returns x^a times f, computed from the smaller one of a and 1 + a. The larger one has lost the digits that determine
/// the power of a tiny x.
template <Real R>
R times_power(const R& f, const Power<R>& a, const R& x) {
  return a.plus_one < 0.5 ? f * pow(x, a.plus_one) / x : f * pow(x, a.value);
}

}  // namespace

template <Real R>
R left_of(const Power<R>& a, const R& distance) {
  const R v = 1 / (1 + distance);
  if (distance >= crossover) return v * euler_series(a.plus_one, v);
  // y^a = y^(a-1) ((y + d) - d)
  if (a.value >= 0.25) return 1 / a.value - distance * left_of(Power<R>{a.value - 1, a.value}, distance);
  // The half-line gives pi d^a/sin(pi (1+a)). Subtract the part beyond 1, sum_k (-d)^k/(k-a).
  const R tail = distance * v * euler_series(1 - a.value, distance * v);
  if (a.value <= -0.25) {
    const R whole = times_power(pi<R>() / sin(pi<R>() * a.plus_one), a, distance);
    return whole + (1 / a.value + tail);
  }
  const R quotient = power_quotient(a.value, distance);
  return tail - quotient - (1 + a.value * quotient) * cosecant_rest(a.value);
}

#define STEADYSLIDE_INSTANTIATE(R) template R left_of(const Power<R>&, const R&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric::second_kind
