#pragma once
// Common parts of the tests of the numeric layer.

#include "numeric/number/estimate.hpp"
#include "numeric/number/real.hpp"
#include "support/test.hpp"

using namespace steadyslide::numeric;

TYPE_TO_STRING(Real50);
TYPE_TO_STRING(Real100);

/// Returns |x| as a number, not as an expression template.
template <class R>
R size_of(const R& x) {
  using std::abs;
  return abs(x);
}

/// The true error of a number in double, measured with more digits.
inline double off_by(const Estimate<double>& found, const Estimate<Real50>& truth) {
  return static_cast<double>(size_of(Real50(found.value - truth.value)));
}

/// True if the estimated error covers the true one.
inline bool within_error(const Estimate<double>& found, const Estimate<Real50>& truth) {
  return off_by(found, truth) <= found.error;
}

/// |a - b| <= units of epsilon times the size of a, of b and of the terms that cancel in them.
template <class R>
bool close(const R& a, const R& b, double units, const R& part = R(0)) {
  return size_of(R(a - b)) <= units * epsilon<R>() * std::max({size_of(a), size_of(b), size_of(part)});
}
