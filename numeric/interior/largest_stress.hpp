#pragma once
// The largest von Mises stress in the body, and where it is.
//
// It has no bound next to a singular point of the surface where the traction has a negative power or a logarithm, or where
// the friction jumps under a pressure that is not 0 (a corner on a jump: then sigma_xx has a logarithm). So it is sought at
// depths of at least a given one. Depth 0, for contacts without such points, stands for 1e-30 of the contact's width.
//
// Scanned are places beside and below every panel of the traction, and every group of neighbouring panels, at depths like
// its length and at the least one: at a depth z the field varies on the scale z along x, unless the panels above are
// longer, and then on theirs. From the highest places Newton's steps lead to maxima, on stencils that shrink.

#include <optional>
#include <vector>

#include "numeric/interior/interior_stress.hpp"

namespace steadyslide::numeric {

template <Real R>
struct LargestStress {
  R depth;  ///< the least one considered
  Estimate<R> von_mises;
  Estimate<R> x;
  Estimate<R> z;
};

/// The places of the surface next to which stresses have no bound.
template <Real R>
std::vector<Estimate<R>> unbounded_places(const ContactSolution<R>& solution);

/// A hundredth of the contact's width, from end to end, where there are such places, else 0.
template <Real R>
R default_depth(const ContactSolution<R>& solution);

/// Absent without Poisson's ratio. Throws std::invalid_argument if depth < 0.
template <Real R>
std::optional<LargestStress<R>> largest_stress(const InteriorStress<R>& stress, const R& depth);

}  // namespace steadyslide::numeric
