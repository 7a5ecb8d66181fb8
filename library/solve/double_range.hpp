#pragma once
// Sizes that double can work with.

#include <cmath>

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::library {

/// Zero, or of a size whose squares and quotients neither overflow nor vanish in double. False of what is no number, too.
template <numeric::Real R>
bool squares_in_double(const R& value) {
  using std::abs;
  const R size = abs(value);
  return size == 0 || (size > R(1e-150) && size < R(1e150));
}

/// Zero, or of a size that double has with all its digits: enough for what nothing else is calculated from, as an intensity at
/// the end of a gap of 1e-200.
template <numeric::Real R>
bool has_double(const R& value) {
  using std::abs;
  const R size = abs(value);
  return size == 0 || (size > R(1e-300) && size < R(1e300));
}

/// Has it nothing to lose in double: not known, or to three digits only, or infinite, or of such a size?
template <numeric::Real R>
bool is_in_range(const numeric::Estimate<R>& estimate, bool (*fits)(const R&) = squares_in_double<R>) {
  using std::abs, std::isinf;
  if (isinf(estimate.error) || isinf(estimate.value)) return true;
  const bool is_rough = estimate.error >= abs(estimate.value) / 1000 && estimate.error < R(1e300);
  return is_rough || fits(estimate.value);
}

}  // namespace steadyslide::library
