#pragma once
// The layout of two coatings with given shares of the contact under which a flat punch has the largest or the smallest
// friction: inner | outer never, but outer | inner | outer with two jumps,
//
//   largest: the coating of larger alpha outside, smallest: inside,   w(first jump) = w(second jump).
//
// Why: among all mixtures 0 <= share(y) <= 1 of both coatings s_eff has a largest value (the set is weak-* compact, s_eff
// continuous on it). There no admissible change increases s_eff: int w (alpha - alpha*) <= 0, so that alpha* is largest
// where w is (bathtub principle). w is strictly convex with infinite limits at both ends: {w < const} is an interval
// strictly inside. Smallest: the same with the signs turned.
// Where the interval lies is a strictly concave problem (convex for the smallest): with D the difference of the
// alphas, 0 < D < 1, phi half the length of the interval and c its centre, c enters by h(z) = ((z-phi)/(z+phi))^D, z = x+c in e^A
// and, inverted, z = x-c in e^-B, and
//   h'' = 4 D phi (D phi - z)/(z^2-phi^2)^2 h < 0,   (1/h)'' > 0   for z > phi.
// So the difference of w at the two jumps falls as c grows, and its zero is the only one.

#include "numeric/flat_punch/effective_friction.hpp"

namespace steadyslide::numeric {

template <Real R>
struct ExtremeLayout {
  Estimate<R> left;   ///< the length of the first strip, of a contact whose length is 1
  Estimate<R> right;  ///< the length of the last strip
  FrictionLayout<R> layout;
  Estimate<R> s_eff;
};

/// Of largest s_eff if s_outer > s_inner, else of smallest; either sign. Throws std::invalid_argument unless they differ
/// and 0 < inner_share < 1; std::range_error where a strip is shorter than 1e-200 of the contact: it takes large friction,
/// and an inner share next to 1.
template <Real R>
ExtremeLayout<R> extreme_layout(const Rational& s_outer, const Rational& s_inner, const Rational& inner_share);

}  // namespace steadyslide::numeric
