#pragma once
// The place in a cell at which an equation of the discrete problem applies.
//
// Galerkin's equations are means over cells. For the friction integral of pressures on cells this is the trapezoidal
// rule, for which alternating pressures have no effect: on a line of cells of length h the symbol of B at the wave
// number theta/h is
//
//   h (l(theta) - i s/2 cot(theta/2)),   l(theta) about 1/theta,   l(pi) = 0.27,
//
// which does not contain s at theta = pi. For s >= 5, pressures oscillate behind an end or a jump, over s cells and
// more, and open false gaps. If the equation and the profile are taken at the end of the cell, the symbol is
//
//   h exp(i theta/2) (m(theta) - i s/(2 sin(theta/2))),   m = 2 sin(theta/2) sum over k = theta + 2 pi n of  1/(k |k|) >= 0.
//
// The friction integral is then correct for any pressure within the cells, because it is the sum of the forces before
// the end of the cell; this also holds for a pressure that is concentrated at an edge. m is 1/theta up to theta/24, and
// 0 at theta = pi, where the friction term is s/2. So no mode is lost and none is smaller than s/2. This rule is for
// large |s| only.

namespace steadyslide::numeric::variational {

enum class FrictionRule {
  galerkin,  ///< means over all cells; theorems on cells hold for this rule
  damped     ///< if |s| > strong_friction: at the cell's right end for s > 0, at its left end for s < 0
};

inline constexpr double strong_friction = 2;

}  // namespace steadyslide::numeric::variational
