#pragma once
// The largest mean pressure over windows of one length. It is finite at singular points and does not depend on a mesh.
//
// Windows lie between the first and the last end of contact; if these are closer together than the length, the window is
// from end to end. The load W(b) - W(a) of a window is analytic in a as long as no end of the window passes an end of a
// panel, and it is at most W(b') - W(a') for windows inside [a', b']. Stretches of a with a smaller bound than the best
// value so far are left out; the others are searched as largest pressures are (highest_peak.hpp).

#include "numeric/number/estimate.hpp"
#include "numeric/solution/piecewise_traction.hpp"

namespace steadyslide::numeric {

template <Real R>
struct AveragePressure {
  Estimate<R> value;
  Estimate<R> x;  ///< the centre of the window
};

/// Returns the largest average; NaN without contact. Throws std::invalid_argument unless length > 0.
template <Real R>
AveragePressure<R> largest_average_pressure(const PiecewiseTraction<R>& traction, const R& length);

}  // namespace steadyslide::numeric
