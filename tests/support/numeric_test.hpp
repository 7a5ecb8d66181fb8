#pragma once
// What the tests of the numeric layer start from.

#include "numeric/number/real.hpp"
#include "support/test.hpp"

using namespace steadyslide::numeric;

TYPE_TO_STRING(Real50);
TYPE_TO_STRING(Real100);

/// |x|, a number and no expression.
template <class R>
R size_of(const R& x) {
  using std::abs;
  return abs(x);
}
