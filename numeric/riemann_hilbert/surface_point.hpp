#pragma once

#include <cstddef>

#include "numeric/riemann_hilbert/contact_set.hpp"

namespace steadyslide::numeric {

/// A point of the surface: in a segment of the contact set, or at the distance `from_right` to the left of the support
/// (segment -1), or at the distance `from_left` to the right of it (segment = number of segments).
template <Real R>
struct SurfacePoint {
  std::ptrdiff_t segment;
  Node<R> node;
};

/// In a segment, the place taken from the nearer end.
template <Real R>
SurfacePoint<R> surface_point(const ContactSet<R>& set, std::size_t segment, const R& from_left, const R& from_right) {
  const R x = from_left < from_right ? R(set.x(segment) + from_left) : R(set.x(segment + 1) - from_right);
  return {static_cast<std::ptrdiff_t>(segment), {x, from_left, from_right}};
}

/// At the distance d from point j of the set, on that side of it; beyond the support the other distance is infinite.
template <Real R>
SurfacePoint<R> beside(const ContactSet<R>& set, std::size_t j, Side side, const R& d) {
  const bool left = side == Side::left;
  const std::ptrdiff_t segment = static_cast<std::ptrdiff_t>(j) - (left ? 1 : 0);
  const bool in_support = segment >= 0 && segment < static_cast<std::ptrdiff_t>(set.segments());
  const R rest = in_support ? R(set.length(static_cast<std::size_t>(segment)) - d) : infinity<R>();
  return {segment, left ? Node<R>{set.x(j) - d, rest, d} : Node<R>{set.x(j) + d, d, rest}};
}

}  // namespace steadyslide::numeric
