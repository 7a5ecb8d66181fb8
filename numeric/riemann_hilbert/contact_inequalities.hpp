#pragma once
// What Newton's method does not know: t <= 0 throughout the contact, gap >= 0 throughout the rest.

#include <string>
#include <vector>

#include "numeric/riemann_hilbert/riemann_hilbert_form.hpp"

namespace steadyslide::numeric {

/// A stretch where an inequality fails.
template <Real R>
struct Violation {
  enum class What { tension, penetration } what;
  SurfacePoint<R> from;
  SurfacePoint<R> to;
};

/// Left to right; what rounding alone may have done is let pass. Sampled, not proved.
template <Real R>
std::vector<Violation<R>> violations(const RiemannHilbertForm<R>& form);

}  // namespace steadyslide::numeric
