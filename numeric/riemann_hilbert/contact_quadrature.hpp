#pragma once
// Integrals over the contact with the weight eps cos(pi alpha)/|Y|, by Gauss-Jacobi panels:
//
//   (g, k) -> int eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x),   int eps cos(pi alpha) (g + tilt)/|Y| xi^j dxi
//
// with g the slope of the profile and g_k its polynomial on one piece.

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "numeric/number/estimate.hpp"
#include "numeric/quadrature/distant_sum.hpp"
#include "numeric/quadrature/graded_sum.hpp"
#include "numeric/quadrature/local_sum.hpp"
#include "numeric/riemann_hilbert/jacobi_panels.hpp"

namespace steadyslide::numeric {

class NodeLine;

/// The contribution of a node to an integral of g. Its rounding errors come from g, the weight and the distance from a
/// point.
template <Real R>
Estimate<R> node_term(const R& factor, const Estimate<R>& g) {
  return factor * g.widened(8 * epsilon<R>());
}

template <Real R>
class ContactQuadrature {
 public:
  /// Both arguments must outlive this object. There are no panels if there is one component with one polynomial: then
  /// all integrals are 0.
  ContactQuadrature(const SignedFundamentalSolution<R>& y, JacobiRules<R>& rules);

  /// True if all integrals are 0, because there is one component with one polynomial.
  bool vanishes() const { return panels_.empty(); }
  /// Returns the first integral at a point outside the pieces with another polynomial than g_k. |Y| is that of the
  /// point's component. The error is the sum of the absolute values of the terms.
  Estimate<R> cauchy(std::size_t slope, const SurfacePoint<R>& at) const;
  /// Returns -(1/pi) times the second integral for j = 0, 1, ...
  std::vector<Estimate<R>> moments(const R& tilt, std::size_t count) const;
  /// Returns -(1/pi) int eps cos(pi alpha) (g - g_k)/|Y| xi^j for j = 0, 1, ...
  std::vector<Estimate<R>> difference_moments(std::size_t slope, std::size_t count) const;
  /// Returns -(1/pi) int eps cos(pi alpha) (g + tilt)/(|Y| (xi - e_i)), where e_i is the pivot of a component.
  Estimate<R> pivot_moment(std::size_t component, const R& tilt) const;

 private:
  struct Panel {
    JacobiPanel<R> rule;
    std::size_t first;  ///< its first node
  };

  /// eps cos(pi alpha) (g - g_k)/|Y_i| times the rule's weight, at nodes.
  struct Density {
    std::vector<R> values;
    /// Near a break g - g_k is a small difference: the error from the rounding of g and g_k, in units of 4 epsilon.
    std::vector<double> rounding;
  };
  /// Returns the density at every node of the contact; the other overload takes the weights of consecutive nodes.
  const Density& density(std::size_t slope, std::size_t component = 0) const;
  Density density(std::size_t slope, const R* weights, std::size_t first, std::size_t count) const;
  std::size_t first_node(std::size_t segment) const {
    return first_panel_[segment] < panels_.size() ? panels_[first_panel_[segment]].first : nodes_.size();
  }
  /// Returns xi - e at the nodes of the segments first..end-1.
  std::vector<R> distances_to(std::size_t point, std::size_t first, std::size_t end) const;
  /// Returns the weights of these nodes times (xi - e_i)^-sigma_i.
  std::vector<R> weights_beside(std::size_t component, std::size_t first, std::size_t end) const;
  /// Takes the density and its rounding at the panel's nodes.
  Estimate<R> panel_cauchy(const Panel& panel, std::size_t slope, std::size_t component, const SurfacePoint<R>& at,
                           const R& between, const R* density, const double* rounding) const;
  /// Sums over the segments first..end-1 one by one, with the density at their nodes.
  Estimate<R> sum_of_panels(std::size_t slope, std::size_t component, const SurfacePoint<R>& at, std::size_t first,
                            std::size_t end, const Density& density) const;

  /// Returns a panel's moments for far points, in higher precision than double and without pivots. Null until the
  /// number of calls is so large that moments pay off.
  const DistantSum<R>* distant_sum(const Panel& panel, std::size_t slope, const R* density) const;
  /// The same for a segment with many panels, for places beyond that end of the segment.
  GradedSum<R>* graded_sum(std::size_t segment, Side end, std::size_t slope, const Density& density) const;

  /// With pivots: the sum of far segments, as a series in a segment, or in the half of it that belongs to one
  /// component.
  struct Local {
    std::ptrdiff_t segment = -1;
    std::size_t component = 0;
    std::size_t slope = 0;
    std::size_t asked = 0;
    R begin = 0;  ///< start of the half
    R length = 0;
    std::vector<char> is_far;  ///< for each segment
    LocalSum<R> sum;
    double rounding = 0;  ///< of the sum, from that of the density
  };
  /// Returns the series for a place, in higher precision than double. Null until the number of consecutive places in
  /// the same segment is so large that the series pays off.
  const Local* local_sum(std::size_t slope, std::size_t component, const SurfacePoint<R>& at,
                         const Density& density) const;

  // In double, far panels are summed by cells (contact_quadrature_cells.cpp).
  struct Cells;
  /// Returns the cells; null for few panels, and until the number of sums is so large that cells pay off.
  Cells* cells() const requires std::same_as<R, double>;
  NodeLine node_line(std::size_t first, std::size_t end,
                     std::span<const R> weights) const requires std::same_as<R, double>;
  void make_own(Cells& cells, std::size_t component) const requires std::same_as<R, double>;
  Estimate<R> cauchy_by_cells(Cells& cells, std::size_t slope,
                              const SurfacePoint<R>& at) const requires std::same_as<R, double>;
  Estimate<R> pivot_moment_by_cells(const Cells& cells, std::size_t component,
                                    const R& tilt) const requires std::same_as<R, double>;
  R node_distance(const Panel& panel, std::size_t i, bool is_right, const R& to_panel) const;

  const SignedFundamentalSolution<R>* y_;
  std::vector<Panel> panels_;
  std::vector<std::size_t> first_panel_;  ///< for each segment; one entry more than segments
  std::vector<SurfacePoint<R>> nodes_;
  std::vector<R> node_weights_;
  /// Protects all data that is computed at first use, because several threads may evaluate places of one solution.
  std::shared_ptr<std::mutex> making_ = std::make_shared<std::mutex>();
  mutable std::vector<Density> densities_;  ///< computed at first use; of many, only the last is kept
  struct DistantPanel {
    std::size_t asked = 0;
    DistantSum<R> sum;
  };
  mutable std::vector<std::vector<DistantPanel>> distant_;  ///< for each slope, panel by panel
  struct GradedSegment {
    std::size_t asked = 0;
    GradedSum<R> sum;
  };
  mutable std::map<std::tuple<std::size_t, std::size_t, Side>, GradedSegment> graded_;  ///< by slope, segment and end
  // With pivots: the data of the last place, because consecutive places are usually neighbours.
  mutable std::size_t last_component_ = 0;
  mutable std::size_t last_slope_ = 0;
  mutable std::vector<R> last_weights_;
  mutable Density last_density_;
  mutable Local local_;
  mutable std::shared_ptr<Cells> cells_;
  mutable std::size_t evaluations_ = 0;
};

}  // namespace steadyslide::numeric
