#pragma once
// A place x of the surface as two numbers, x = high + low, low = x - high rounded. The difference of two places has a
// relative error of about epsilon, also if they are very close, as long as it exceeds epsilon^2 |x|.

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
  /// Returns the place moved along +x.
  SurfacePlace moved(const R& distance) const {
    // The digits that high + distance loses.
    const R sum = high + distance;
    const R part = sum - high;
    const R rest = low + ((high - (sum - part)) + (distance - part));
    const R moved_high = sum + rest;
    return {moved_high, rest - (moved_high - sum)};
  }
};

}  // namespace steadyslide::numeric
