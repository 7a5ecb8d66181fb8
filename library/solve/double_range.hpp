#pragma once
// Tests whether the size of a number suits double.

#include <cmath>

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::library {

/// True for zero and for sizes whose squares and quotients neither overflow nor underflow in double. False for NaN.
template <numeric::Real R>
bool squares_in_double(const R& value) {
  using std::abs;
  const R size = abs(value);
  return size == 0 || (size > R(1e-150) && size < R(1e150));
}

/// True for zero and for sizes that double represents with full precision. That is enough for numbers that enter no
/// further computation, such as an intensity at the end of a gap of 1e-200.
template <numeric::Real R>
bool has_double(const R& value) {
  using std::abs;
  const R size = abs(value);
  return size == 0 || (size > R(1e-300) && size < R(1e300));
}

/// True if double loses nothing: the estimate is unknown, infinite, accurate to three digits only, or of a size that
/// `fits`.
template <numeric::Real R>
bool is_in_range(const numeric::Estimate<R>& estimate, bool (*fits)(const R&) = squares_in_double<R>) {
  using std::abs, std::isinf;
  if (isinf(estimate.error) || isinf(estimate.value)) return true;
  const bool is_rough = estimate.error >= abs(estimate.value) / 1000 && estimate.error < R(1e300);
  return is_rough || fits(estimate.value);
}

}  // namespace steadyslide::library
