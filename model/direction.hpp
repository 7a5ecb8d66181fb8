#pragma once
// Directions on the surface. Coordinates are the user's x, left to right, whichever way the indenter slides.

namespace steadyslide {

/// A one-sided limit at c, or the side of c on which there is contact: left is x < c, right is x > c.
enum class Side { left, right };

/// Which end of a contact component a point is.
using End = Side;

/// The indenter moves towards +x or -x. Sliding towards -x is the same problem with s = gamma f of the other sign:
/// the mirror x -> -x turns (1/pi) PV int t/(x'-x) into its negative and leaves s t.
enum class Sliding { plus_x = +1, minus_x = -1 };

inline constexpr Side opposite(Side side) { return side == Side::left ? Side::right : Side::left; }

}  // namespace steadyslide
