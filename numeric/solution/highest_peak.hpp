#pragma once
// Where a function of the surface is largest, panels of it being analytic inside: branch and bound.
//
// On a part of a panel the function is interpolated at 16 Chebyshev points. The sum of the coefficients' sizes bounds the
// interpolant, the last ones estimate what it misses: a part whose bound is below the best value so far is done with.
// Others are halved until the interpolant is exact to 1e-10, which is then searched by the bound p(m) + |p'(m)| h + M h^2/2
// on [m - h, m + h], M >= |p''|. The place found is improved to full precision by an interpolant around it.
// (Heuristic: singular points on the real axis and nothing else, as pressures have. A narrow peak over a pole beside the
// axis could hide between the points.)

#include <functional>
#include <vector>

#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

template <Real R>
struct Peak {
  std::size_t panel;
  R from_left;  ///< of the panel
  R from_right;
  Estimate<R> value;
  R place_error;
};

/// At a place of a panel, by the distances from its ends, both positive.
template <Real R>
using PanelFunction = std::function<Estimate<R>(std::size_t panel, const R& from_left, const R& from_right)>;

/// The largest value above `floor` on panels of these lengths, then other peaks that are as high as far as their errors
/// tell; none if none is higher than the floor. Next to an end of a panel, closer than 2^-60 of it, nothing is looked for: the
/// limits there are the caller's, as the floor.
template <Real R>
std::vector<Peak<R>> highest_peaks(const std::vector<R>& lengths, const PanelFunction<R>& f, const R& floor = R(0));

}  // namespace steadyslide::numeric
