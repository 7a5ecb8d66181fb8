#pragma once
// Common parts of the tests of enclosures: balls with exact points inside. The number of cases is RapidCheck's
// max_success, which CMake sets: 10^3, and 10^5 in the slow test.

#include "enclosure/number/ball.hpp"
#include "support/test.hpp"

using namespace steadyslide::enclosure;

/// 2^n.
inline Rational two_to(int n) {
  const Rational power = Rational(Integer(1) << std::abs(n));
  return n < 0 ? Rational(1 / power) : power;
}

/// A ball and an exact number in it.
struct Sample {
  Ball ball;
  Rational point;
};

inline Ball midpoint_and_radius(const Rational& midpoint, const Rational& radius, Bits bits) {
  return Ball::around(Ball(midpoint, 4096), Ball(radius, 4096)).at(bits);
}

/// A ball between low and high (multiples of 1/1024), with a midpoint that has up to 30 more bits: exact, thin or wide;
/// its point lies anywhere inside or at an end.
inline Sample sample(int low, int high, Bits bits) {
  const Rational fine = Rational(uniform(0, 1 << 15)) * two_to(-25);
  Rational midpoint = Rational(uniform(low * 1024, high * 1024 - 1)) / 1024 + fine;
  if (uniform(0, 7) == 0) midpoint = Rational(uniform(low, high));
  Rational radius = two_to(-uniform(0, 2 * static_cast<int>(bits)));
  radius = std::min({radius, Rational(midpoint - low), Rational(high - midpoint)});
  if (uniform(0, 3) == 0) radius = 0;
  const Rational point = midpoint + radius * Rational(uniform(-8, 8)) / 8;
  return {midpoint_and_radius(midpoint, radius, bits), point};
}

/// The number with so many bits that its ball is very thin.
inline Ball tight(const Rational& point, Bits bits) { return Ball(point, 3 * bits + 256); }

/// A random number of bits from 30 to 300.
inline Bits some_bits() { return uniform(30, 300); }

/// T_k(t).
inline Ball chebyshev_polynomial(int k, const Ball& t) {
  Ball before(1, t.bits()), here = t;
  for (int i = 1; i < k; ++i) before = std::exchange(here, 2 * t * here - before);
  return here;
}
