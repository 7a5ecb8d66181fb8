#pragma once
// Points with their distances from the ends of a panel. Powers at an end are computed from the distance to that end,
// because 1 - x loses digits close to the end.

#include <algorithm>
#include <utility>

#include "model/direction.hpp"
#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <Real R>
struct Node {
  R x;
  R from_left;   ///< distance to the left end of the panel
  R from_right;  ///< distance to the right end of the panel

  Node moved(const R& d) const { return {x + d, from_left + d, from_right - d}; }
};

/// An interval between two neighbouring singular points. `length` is more accurate than right - left.
template <Real R>
struct Panel {
  R left;
  R right;
  R length;

  Node<R> node_from_left(const R& distance) const { return {left + distance, distance, length - distance}; }
  Node<R> node_from_right(const R& distance) const { return {right - distance, length - distance, distance}; }
  Node<R> node_from(Side end, const R& distance) const {
    return end == Side::left ? node_from_left(distance) : node_from_right(distance);
  }
};

/// Returns a position in ]0, 1[, number i of n (Chebyshev's points), and 1 minus the position without cancellation.
/// These places for samples are denser towards both ends, where tractions are singular.
template <Real R>
std::pair<R, R> chebyshev_position(int i, int n) {
  const R angle = pi<R>() * (2 * i + 1) / (4 * n);
  const R s = sin(angle);
  const R c = cos(angle);
  return {s * s, c * c};
}

}  // namespace steadyslide::numeric
