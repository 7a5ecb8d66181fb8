#pragma once
// An estimate of a contact component: an interval of the surface, in double.

namespace steadyslide::numeric {

/// The owner of the interval defines its origin and unit.
struct ContactInterval {
  double left;
  double right;
  bool left_at_edge;   ///< `left` is the support's end, or a step whose lower face is on the other side
  bool right_at_edge;  ///< the same for `right`
};

}  // namespace steadyslide::numeric
