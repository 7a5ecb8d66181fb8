#pragma once
// A place x of the surface as two numbers, x = high + low, low = x - high rounded. The difference of two places is right to
// about epsilon relative to itself, however close they are, as long as it is above epsilon^2 |x|.

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <Real R>
struct SurfacePlace {
  R high;
  R low;

  static SurfacePlace of(const Rational& x) {
    const R high = to_real<R>(x);
    return {high, isfinite(high) ? to_real<R>(x - Rational(high)) : R(0)};
  }

  friend R operator-(const SurfacePlace& a, const SurfacePlace& b) { return (a.high - b.high) + (a.low - b.low); }
  /// Moved along +x.
  SurfacePlace moved(const R& distance) const {
    // What high + distance loses.
    const R sum = high + distance;
    const R part = sum - high;
    const R rest = low + ((high - (sum - part)) + (distance - part));
    const R moved_high = sum + rest;
    return {moved_high, rest - (moved_high - sum)};
  }
};

}  // namespace steadyslide::numeric
