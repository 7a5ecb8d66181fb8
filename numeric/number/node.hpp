#pragma once
// Points that know their distances. Powers at the end of a panel are formed from the distance to that end: 1 - x has
// lost its digits where they matter most.

#include <algorithm>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <Real R>
struct Node {
  R x;
  R from_left;   ///< distance to the left end of the panel
  R from_right;  ///< distance to the right end of the panel
};

/// An interval between two neighbouring singular points. `length` is known better than right - left.
template <Real R>
struct Panel {
  R left;
  R right;
  R length;

  Node<R> node_from_left(const R& distance) const { return {left + distance, distance, length - distance}; }
  Node<R> node_from_right(const R& distance) const { return {right - distance, length - distance, distance}; }
};

}  // namespace steadyslide::numeric
