#pragma once
// Heights over the gap beside one end of contact, by integration of Y B_k from that end.

#include <optional>
#include <vector>

#include "numeric/riemann_hilbert/traction_representation.hpp"

namespace steadyslide::numeric {

/// A node of a rule for functions like Y/(x - e) at the ends of a gap.
template <Real R>
struct GapNode {
  SurfacePoint<R> at;
  std::size_t slope;  ///< the k at this node
  R weight;
  R y;         ///< Y, with its sign, of all components
  R to_pivot;  ///< Y_i/Y, where i is the component of the place

  /// Returns weight Y f, for f = B Y_i/Y. It multiplies Y by f first, because for a tiny gap the weight times Y may be
  /// out of range. The rounding error of its powers is proportional to the logarithms of distances.
  Estimate<R> term(Estimate<R> f) const {
    f *= y;
    return weight * f.widened((8 + abs(log(abs(y)))) * epsilon<R>());
  }
};

template <Real R>
class GapIntegral {
 public:
  /// Takes the gap beside the end of contact at point `end` of the set. `errors` are the errors of the state; without
  /// them it counts as exact. `form` must outlive this object.
  GapIntegral(const TractionRepresentation<R>& form, std::size_t end,
              std::optional<StateErrors<R>> errors = std::nullopt)
      : form_(&form), end_(end), errors_(std::move(errors)) {}

  /// Returns a rule over the whole gap, which begins at the end.
  std::vector<GapNode<R>> rule() const;
  /// Returns the difference in height between surface and profile at the far end of the gap; 0 for a solution.
  Estimate<R> closure_error(const std::vector<GapNode<R>>& rule) const;

  /// Returns the gap at a point, divided by c, measured from the end. Sums over whole segments are kept for the next
  /// points. Throws std::domain_error outside the support.
  Estimate<R> reduced_gap(const SurfacePoint<R>& at) const;
  /// Returns the tilted profile's height at a point of the gap minus the height at the end, on the side of the contact.
  /// Sums over whole segments are kept.
  R profile_increment(const SurfacePoint<R>& at) const;

 private:
  const ContactSet<R>& set() const { return form_->set(); }
  bool is_rightwards(const SurfacePoint<R>& at) const { return static_cast<std::ptrdiff_t>(end_) <= at.segment; }
  /// Returns the gap's rise over a part of a segment, away from the end, with the step of the profile on the near side.
  Estimate<R> rise(const SegmentPart<R>& part, bool rightwards) const;
  /// Returns the step of the profile at point j, right minus left; 0 if there is none.
  R step(std::size_t j) const;
  std::size_t slope_on(std::size_t segment, bool left_half) const;
  /// True if both halves belong to the same component and use the same k.
  bool is_uniform(std::size_t segment) const;
  void add_nodes(const SegmentPart<R>& part, std::vector<GapNode<R>>& nodes) const;
  void add_nodes(const SegmentPart<R>& part, std::size_t slope, std::vector<GapNode<R>>& nodes) const;
  /// Returns int (profile slope - g_k) over a part of a gap segment, with the k of the gap's nodes.
  Estimate<R> slope_difference(const SegmentPart<R>& part) const;

  const TractionRepresentation<R>* form_;
  std::size_t end_;
  std::optional<StateErrors<R>> errors_;
  // The sums over the first segments, counted from the end: of the gap, and of the profile.
  mutable std::vector<Estimate<R>> rises_;
  mutable std::vector<R> profile_rises_;
};

}  // namespace steadyslide::numeric
