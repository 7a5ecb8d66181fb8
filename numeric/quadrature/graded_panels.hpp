#pragma once
// Divides an interval into parts, for a function with singular points outside the interval and powers at its ends. On
// every part the function is smooth except for at most one power. So Gauss-Jacobi rules converge geometrically, at a
// rate that does not depend on the distances between singular points.

#include <optional>
#include <vector>

#include "model/direction.hpp"
#include "numeric/number/node.hpp"

namespace steadyslide::numeric {

/// A part of an interval: its start, the distance of its end from the interval's right end, and its length.
template <Real R>
struct GradedPanel {
  R from_left;
  R from_right;
  R length;
  std::optional<Side> singular_end;  ///< the end of the part with a power of the distance
};

/// The singular points nearest to an interval.
template <Real R>
struct Surroundings {
  bool left_singular;  ///< there is a power at the interval's own left end
  bool right_singular;
  R beyond_left;  ///< distance from the left end to the next singular point on its left
  R beyond_right;
};

/// Returns the parts. No part is longer than its distance from any singular point, except the one at its own end.
template <Real R>
std::vector<GradedPanel<R>> graded_panels(const R& length, const Surroundings<R>& around) {
  std::vector<GradedPanel<R>> done;
  std::vector<GradedPanel<R>> waiting{{R(0), R(0), length, std::nullopt}};
  while (!waiting.empty()) {
    GradedPanel<R> part = waiting.back();
    waiting.pop_back();
    const bool at_left = part.from_left == 0;
    const bool at_right = part.from_right == 0;
    const bool owns_left = at_left && around.left_singular;
    const bool owns_right = at_right && around.right_singular;
    const auto far = [&](bool own_end_singular, const R& to_end, const R& beyond) {
      if (own_end_singular && to_end > 0) return part.length <= to_end;
      return part.length <= to_end + beyond;
    };
    // A part with a power at one end must not reach the other end of the interval. Then the distance of places beyond
    // that end is at least the length of the part.
    const bool clear = !(owns_left && at_right) && !(owns_right && at_left);
    if (clear && far(around.left_singular, part.from_left, around.beyond_left) &&
        far(around.right_singular, part.from_right, around.beyond_right)) {
      if (owns_left) part.singular_end = Side::left;
      if (owns_right) part.singular_end = Side::right;
      done.push_back(part);
      continue;
    }
    const R half = part.length / 2;
    waiting.push_back({part.from_left + half, part.from_right, half, std::nullopt});
    waiting.push_back({part.from_left, part.from_right + half, half, std::nullopt});
  }
  return done;
}

}  // namespace steadyslide::numeric
