#pragma once
// What Newton's method does not know: t <= 0 throughout the contact, gap >= 0 throughout the rest.

#include <string>
#include <vector>

#include "numeric/riemann_hilbert_form.hpp"

namespace steadyslide::numeric {

/// A stretch where an inequality fails: from a place in one segment to a place in the same or a later one.
template <Real R>
struct Violation {
  enum class What { tension, penetration } what;
  std::size_t first_segment;
  R from;  ///< distance from the left end of that segment
  std::size_t last_segment;
  R to;
  R size;  ///< the largest eps B, which has the sign of t, or the deepest reduced penetration, in it
};

/// Left to right; what rounding alone may have done is let pass. Sampled, not proved.
template <Real R>
std::vector<Violation<R>> violations(const RiemannHilbertForm<R>& form);

}  // namespace steadyslide::numeric
