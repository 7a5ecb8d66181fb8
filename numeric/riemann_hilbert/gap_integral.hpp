#pragma once
// Heights over the gap beside one end of contact, by exact integration of Y B_k from there.

#include <optional>
#include <vector>

#include "numeric/riemann_hilbert/traction_representation.hpp"

namespace steadyslide::numeric {

/// Of a rule for functions like Y/(x - e) at the ends of a gap.
template <Real R>
struct GapNode {
  SurfacePoint<R> at;
  std::size_t slope;  ///< the k in use
  R weight;
  R y;         ///< Y, with its sign, of all components
  R to_pivot;  ///< Y_i/Y, i the component the place belongs to

  /// weight Y f, for f = B Y_i/Y. Y alone comes last: over a tiny gap the weight times Y may be no number any more, and the
  /// rounding of its powers counts by the logarithms of distances.
  Estimate<R> term(Estimate<R> f) const {
    f *= y;
    return weight * f.widened((8 + abs(log(abs(y)))) * epsilon<R>());
  }
};

template <Real R>
class GapIntegral {
 public:
  /// The gap that the contact's end, point `end` of the set, faces; of a state known up to `errors`, or taken as it is.
  /// `form` has to outlive it.
  GapIntegral(const TractionRepresentation<R>& form, std::size_t end,
              std::optional<StateErrors<R>> errors = std::nullopt)
      : form_(&form), end_(end), errors_(std::move(errors)) {}

  /// Over the whole gap, which begins at the end.
  std::vector<GapNode<R>> rule() const;
  /// The height that the profile misses at the far end of the gap that begins at the end: zero for a solution.
  Estimate<R> closure_error(const std::vector<GapNode<R>>& rule) const;

  /// The gap at a point of it, over c, measured from the end. What whole segments add is kept, for the next points. Throws
  /// std::domain_error off the support.
  Estimate<R> reduced_gap(const SurfacePoint<R>& at) const;
  /// The tilted profile's height at a point of the gap minus that at the end, on the side of the contact.
  R profile_increment(const SurfacePoint<R>& at) const;

 private:
  const ContactSet<R>& set() const { return form_->set(); }
  bool is_rightwards(const SurfacePoint<R>& at) const { return static_cast<std::ptrdiff_t>(end_) <= at.segment; }
  /// The gap's rise over a part of a segment, away from the end, with the step of the profile on the near side.
  Estimate<R> rise(const SegmentPart<R>& part, bool rightwards) const;
  /// The step of the profile at point j, on the right of it minus on the left; 0 where there is none.
  R step(std::size_t j) const;
  std::size_t slope_on(std::size_t segment, bool left_half) const;
  /// Do both halves belong to one component, and use one k?
  bool is_uniform(std::size_t segment) const;
  void add_nodes(const SegmentPart<R>& part, std::vector<GapNode<R>>& nodes) const;
  void add_nodes(const SegmentPart<R>& part, std::size_t slope, std::vector<GapNode<R>>& nodes) const;
  /// int (profile slope - g_k) over a part of a gap segment, k as the gap's nodes use it.
  Estimate<R> slope_difference(const SegmentPart<R>& part) const;

  const TractionRepresentation<R>* form_;
  std::size_t end_;
  std::optional<StateErrors<R>> errors_;
  mutable std::vector<Estimate<R>> rises_;  ///< the sums over the first segments from the end on
};

}  // namespace steadyslide::numeric
