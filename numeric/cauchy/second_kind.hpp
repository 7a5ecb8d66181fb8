#pragma once
// Cauchy integrals of a power over the unit interval: the functions of the second kind that exact subtraction needs,
//
//   left_of:     int_0^1 y^a/(y + d) dy,     d > 0: a point at the distance d from the end where the power sits,
//   on_interval: PV int_0^1 y^a/(y - x) dy,  0 < x < 1,
//   right_of:    int_0^1 y^a/(1 + d - y) dy, d > 0: a point at the distance d beyond the other end,
//
// for -1 < a < 1, to full relative precision however small d, x or 1 - x, and however near a is to -1 or to 0.

#include "numeric/number/power.hpp"

namespace steadyslide::numeric::second_kind {

template <Real R>
R left_of(const Power<R>& a, const R& distance);

/// `rest` = 1 - x, as exactly as it is known.
template <Real R>
R on_interval(const Power<R>& a, const R& x, const R& rest);

template <Real R>
R right_of(const Power<R>& a, const R& distance);

}  // namespace steadyslide::numeric::second_kind
