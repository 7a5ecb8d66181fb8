#pragma once
// The Cauchy integral of a power over the unit interval that exact subtraction needs, a function of the second kind:
//
//   left_of: int_0^1 y^a/(y + d) dy,   d > 0: a point at the distance d from the end where the power sits,
//
// for -1 < a < 1, to full relative precision however small d is, and however near a is to -1 or to 0.

#include "numeric/number/power.hpp"

namespace steadyslide::numeric::second_kind {

template <Real R>
R left_of(const Power<R>& a, const R& distance);

}  // namespace steadyslide::numeric::second_kind
