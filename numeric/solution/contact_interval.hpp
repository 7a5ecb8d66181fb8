#pragma once
// A contact component as somebody estimates it: an interval of the surface, in double.

namespace steadyslide::numeric {

/// From where it is measured, and in which unit, its holder says.
struct ContactInterval {
  double left;
  double right;
  bool left_at_edge;   ///< `left` is the support's end, or a step whose lower face is on the other side
  bool right_at_edge;  ///< the same of `right`
};

}  // namespace steadyslide::numeric
