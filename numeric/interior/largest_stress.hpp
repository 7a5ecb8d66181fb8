#pragma once
// The largest von Mises stress in the body, and its place.
//
// The stress is unbounded next to a singular point of the surface at which the traction has a negative power or a
// logarithm. It is also unbounded where the friction jumps under a pressure that is not 0 (a corner on a jump: then
// sigma_xx has a logarithm). So only depths from a given one on are considered. Depth 0, for contacts without such
// points, stands for 1e-30 of the contact's width.
//
// The scan covers places beside and below every panel of the traction and every group of neighbouring panels, at depths
// similar to its length and at the smallest depth. At a depth z the field varies on the scale z along x, or on the
// length of the panels above if they are longer. The scan also covers places beside the ends of panels at every scale,
// because a pressure with a power near 0 has its largest stress exponentially close to its singular point. (Places
// nearer than 64 roundings of x are not found.) In layers it covers both sides of each interface. From the highest places, Newton's method on shrinking stencils leads to
// the maxima.

#include <optional>
#include <vector>

#include "numeric/interior/interior_stress.hpp"

namespace steadyslide::numeric {

template <Real R>
struct LargestStress {
  R depth;  ///< the smallest depth considered
  Estimate<R> von_mises;
  Estimate<R> x;
  Estimate<R> z;
};

/// Returns the places of the surface next to which stresses are unbounded.
template <Real R>
std::vector<Estimate<R>> unbounded_places(const ContactSolution<R>& solution);

/// Returns a hundredth of the contact's width (from end to end) if there are such places, or friction jumps in the
/// contact, beside which stresses vary on every scale; otherwise 0.
template <Real R>
R default_depth(const ContactSolution<R>& solution);

/// Returns the largest stress; absent without Poisson's ratio. Throws std::invalid_argument if depth < 0.
template <Real R>
std::optional<LargestStress<R>> largest_stress(const StressField<R>& stress, const R& depth);

}  // namespace steadyslide::numeric
