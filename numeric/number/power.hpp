#pragma once
// The power of a distance, prepared for evaluation.

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

/// lambda and 1 + lambda, each to full relative precision. At an edge with large friction lambda is close to -1, and
/// the load depends on the small number 1 + lambda. Computed in R as a sum, 1 + lambda would lose its digits.
template <Real R>
struct Power {
  R value = 0;
  R plus_one = 1;

  static Power of(const Exponent& exponent) { return {to_real<R>(exponent), to_real<R>(exponent + Exponent(1))}; }
};

}  // namespace steadyslide::numeric
