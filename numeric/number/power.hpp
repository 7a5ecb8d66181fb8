#pragma once
// The power of a distance, ready for evaluation.

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

/// lambda together with 1 + lambda, each to full relative precision: at an edge with large friction lambda is -1 but
/// for a small number on which the load there depends, and which 1 + lambda formed in R would have lost.
template <Real R>
struct Power {
  R value = 0;
  R plus_one = 1;

  static Power of(const Exponent& exponent) { return {to_real<R>(exponent), to_real<R>(exponent + Exponent(1))}; }
};

}  // namespace steadyslide::numeric
