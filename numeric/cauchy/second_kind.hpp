#pragma once
// The Cauchy integral of a power over the unit interval, a function of the second kind. Exact subtraction needs it.
//
//   left_of: int_0^1 y^a/(y + d) dy,   d > 0: a point at the distance d from the singular end,
//
// for -1 < a < 1, to full relative precision for arbitrarily small d and for a arbitrarily close to -1 or 0.

#include "numeric/number/power.hpp"

namespace steadyslide::numeric::second_kind {

template <Real R>
R left_of(const Power<R>& a, const R& distance);

}  // namespace steadyslide::numeric::second_kind
