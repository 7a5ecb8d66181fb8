#pragma once
// Places for samples: denser towards both ends, where tractions are singular.

#include <utility>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

/// A position in ]0, 1[, number i of n (Chebyshev's points); and what is missing to 1, formed without cancellation.
template <Real R>
std::pair<R, R> chebyshev_position(int i, int n) {
  using std::cos, std::sin;
  const R angle = pi<R>() * (2 * i + 1) / (4 * n);
  const R s = sin(angle);
  const R c = cos(angle);
  return {s * s, c * c};
}

}  // namespace steadyslide::numeric
