#pragma once
// Where in its cell an equation of the discrete problem is asked.
//
// Galerkin's equations are means over cells. For the friction integral of pressures on cells that is the trapezoidal rule,
// to which alternating pressures are nothing: on a line of cells of length h the symbol of B at the wave number theta/h is
//
//   h (l(theta) - i s/2 cot(theta/2)),   l(theta) about 1/theta,   l(pi) = 0.27,
//
// without s at theta = pi. Under s of 5 and more pressures ring behind an end or a jump, over s cells and more, and open
// gaps that are none. Asked at the end of the cell, as the profile is, the equations have
//
//   h exp(i theta/2) (m(theta) - i s/(2 sin(theta/2))),   m = 2 sin(theta/2) sum over k = theta + 2 pi n of  1/(k |k|) >= 0.
//
// The friction integral is then right whatever the pressures within the cells, since it is the sum of the forces before its
// end; that also holds for a pressure nearly all of which is at an edge. m is 1/theta up to theta/24 and 0 at theta = pi,
// where the friction's term is s/2: no mode is lost, none is less than s/2. So this is for large |s| only.

namespace steadyslide::numeric::variational {

enum class FrictionRule {
  galerkin,  ///< means over all cells: what theorems on cells speak of
  damped     ///< where |s| > strong_friction, at the cell's right end under s > 0, at its left end under s < 0
};

inline constexpr double strong_friction = 2;

}  // namespace steadyslide::numeric::variational
