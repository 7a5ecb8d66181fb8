#pragma once
// Directions on the surface. Coordinates are the user's x, from left to right, for both directions of sliding.

namespace steadyslide {

/// A one-sided limit at c, or the side of c on which there is contact: left is x < c, right is x > c.
enum class Side { left, right };

/// One end of a contact component, the left or the right one.
using End = Side;

/// The indenter moves towards +x or -x. Sliding towards -x is the same problem with the opposite sign of s = gamma f:
/// the mirror x -> -x changes the sign of (1/pi) PV int t/(x'-x) and keeps s t.
enum class Sliding { plus_x = +1, minus_x = -1 };

inline constexpr Side opposite(Side side) { return side == Side::left ? Side::right : Side::left; }

}  // namespace steadyslide
