#pragma once
// The operator of the sliding contact problem, for a traction given panel by panel [Bal16, (3)]:
//
//   A t(x) = (1/pi) PV int t(x')/(x'-x) dx' + s(x) t(x)

#include <vector>

#include "numeric/cauchy/density.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

/// The unrelated ways to the principal value. GSL works in double only: std::invalid_argument at other precisions.
enum class Route { tanh_sinh, trapezoidal, gsl };

/// A t at a point inside a panel; s holds one value per panel. The trapezoidal route takes its samples anew at every
/// call: for many points of one density use trapezoidal::Grid. Its error is that of rounding; it has no estimate of its
/// own.
template <Real R>
Estimate<R> sliding_operator(const PiecewiseDensity<R>& traction, const std::vector<R>& s, const PanelPoint<R>& at,
                             Route route);

}  // namespace steadyslide::numeric
