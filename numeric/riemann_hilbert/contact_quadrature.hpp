#pragma once
// Integrals over the contact with the weight eps cos(pi alpha)/|Y|, by Gauss-Jacobi panels:
//
//   (g, k) -> int eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x),   int eps cos(pi alpha) (g + tilt)/|Y| xi^j dxi
//
// with g the slope of the profile and g_k its polynomial on one piece.

#include <memory>
#include <vector>

#include "numeric/number/estimate.hpp"
#include "numeric/riemann_hilbert/jacobi_panels.hpp"

namespace steadyslide::numeric {

class DistantNodes;

template <Real R>
class ContactQuadrature {
 public:
  /// Both have to outlive it. No panels where one polynomial rules over one component: all integrals are 0 then.
  ContactQuadrature(const SignedFundamentalSolution<R>& y, JacobiRules<R>& rules);

  /// Are all integrals 0 since one polynomial rules over one component?
  bool vanishes() const { return panels_.empty(); }
  /// The first integral at a point off the pieces where g_k does not hold, |Y| being that of the component the point
  /// belongs to; its error is the sum of the sizes added.
  Estimate<R> cauchy(std::size_t slope, const SurfacePoint<R>& at) const;
  /// -(1/pi) times the second one for j = 0, 1, ...
  std::vector<Estimate<R>> moments(const R& tilt, std::size_t count) const;
  /// Adds -(1/pi) int eps cos(pi alpha) (g - g_k)/|Y| xi^j to moments[j].
  void add_difference_moments(std::size_t slope, std::vector<Estimate<R>>& moments) const;
  /// -(1/pi) int eps cos(pi alpha) (g + tilt)/(|Y| (xi - e_i)), e_i the pivot of a component.
  Estimate<R> pivot_moment(std::size_t component, const R& tilt) const;

 private:
  struct Panel {
    JacobiPanel<R> rule;
    std::size_t first;  ///< of its nodes
  };

  /// eps cos(pi alpha) (g - g_k)/|Y_i| times the rule's weight, at every node of the contact, or at those of one panel, the
  /// weights given.
  const std::vector<R>& density(std::size_t slope, std::size_t component = 0) const;
  std::vector<R> density(std::size_t slope, const std::vector<R>& weights, std::size_t first, std::size_t count) const;
  /// xi - e at every node.
  std::vector<R> distances_to(std::size_t point) const;
  /// Of the panels far away, once they have been asked for so often that it is worth while; null before, and for few
  /// panels.
  const DistantNodes* distant() const;
  Estimate<R> panel_cauchy(const Panel& panel, std::size_t slope, std::size_t component, const SurfacePoint<R>& at,
                           const R& between, const R* density) const;

  const SignedFundamentalSolution<R>* y_;
  std::vector<Panel> panels_;
  std::vector<std::size_t> first_panel_;  ///< of each segment, and one more
  std::vector<SurfacePoint<R>> nodes_;
  std::vector<R> node_weights_;
  mutable std::vector<std::vector<R>> densities_;  ///< made when first asked for: not all are; of many only the last
  // With pivots those of the place asked for last: neighbours follow each other.
  mutable std::size_t last_component_ = 0;
  mutable std::size_t last_slope_ = 0;
  mutable std::vector<R> last_weights_;
  mutable std::vector<R> last_density_;
  mutable std::shared_ptr<const DistantNodes> distant_;
  mutable std::size_t evaluations_ = 0;
};

}  // namespace steadyslide::numeric
