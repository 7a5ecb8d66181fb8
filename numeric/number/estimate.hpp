#pragma once
// A value travels with its error.

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

enum class Convergence { reached, stalled };

/// The value, an estimate (not a bound) of its absolute error, and whether the method reached its tolerance.
template <Real R>
struct Estimate {
  R value = 0;
  R error = 0;
  Convergence convergence = Convergence::reached;
};

}  // namespace steadyslide::numeric
