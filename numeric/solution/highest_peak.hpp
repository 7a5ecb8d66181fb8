#pragma once
// Finds the largest value of a function of the surface that is analytic inside each panel, by branch and bound.
//
// On a part of a panel the function is interpolated at 16 Chebyshev points. The sum of the absolute values of its
// coefficients is a bound of the interpolant; the last coefficients estimate its error. A part whose bound is below the
// best value so far is discarded. Other parts are halved until the interpolant is exact to 1e-10. Then the interpolant
// is searched with the bound p(m) + |p'(m)| h + M h^2/2 on [m - h, m + h], M >= |p''|. The place found is improved to
// full precision by an interpolant around it. (Heuristic: it assumes singular points on the real axis only, as
// pressures have. A narrow peak over a pole beside the axis could lie between the points.)

#include <functional>
#include <vector>

#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

template <Real R>
struct Peak {
  std::size_t panel;
  R from_left;  ///< distance from the left end of the panel
  R from_right;
  Estimate<R> value;
  R place_error;
};

/// Returns the function at a place of a panel, given by its distances from both ends, which are positive.
template <Real R>
using PanelFunction = std::function<Estimate<R>(std::size_t panel, const R& from_left, const R& from_right)>;

/// Returns the largest value above `floor` on panels of these lengths, then other peaks that are equally high within
/// their errors; empty if no value exceeds the floor. Places closer to an end than 2^-60 of the panel are not searched:
/// the caller passes the limits at the ends as the floor.
template <Real R>
std::vector<Peak<R>> highest_peaks(const std::vector<R>& lengths, const PanelFunction<R>& f, const R& floor = R(0));

}  // namespace steadyslide::numeric
