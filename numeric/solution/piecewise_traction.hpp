#pragma once
// The traction of a solution in the form that all methods provide: on each panel of the contact, a power of the
// distance from one of its ends times a polynomial g,
//
//   t(x) = y^p g(y),   y = d/L,   d the distance from the panel's singular end, L its length;   t_t = r t, r a constant.
//
// Panels are not longer than their distance from the next singular point other than their own end. So g is analytic in
// Bernstein's ellipse rho = 3 + sqrt 8, and its Chebyshev series up to degree n has an error of 5.8^-n. Towards a place
// where t has a logarithm, or a constant and a power, panels are halved until the rest carries no load. Cells are
// panels with a constant g, whose error coarser meshes show. In the user's units.

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/direction.hpp"
#include "model/elasticity.hpp"
#include "numeric/number/node.hpp"
#include "numeric/quadrature/graded_panels.hpp"
#include "numeric/quadrature/jacobi_rule.hpp"
#include "numeric/solution/surface_place.hpp"

namespace steadyslide::numeric {

/// A part of a panel: the length on its left, its own length, and the length on its right. Zeros are exact.
template <Real R>
struct PanelPart {
  R from_left;
  R length;
  R from_right;
  R beyond_left = infinity<R>();  ///< distances from its ends to other singular points of an integrand, such as a pole
  R beyond_right = infinity<R>();
};

template <Real R>
struct TractionPanel {
  SurfacePlace<R> left;
  SurfacePlace<R> right;
  R length;
  std::optional<Side> singular_end;  ///< the end with the power; without a power y is measured from the left
  Power<R> power;
  const UnitRule<R>* rule;  ///< for y^p; its nodes are numbered from the singular end
  std::size_t first;        ///< index of the first Chebyshev coefficient of g
  std::size_t count;
  R shear_ratio;  ///< r
  R error;        ///< estimated relative error of t over the panel
  R end_error;    ///< estimated error of the position of its singular end; 0 if it is exact

  /// Returns the estimated relative change of the force at these distances from the ends of a part, if the end is
  /// displaced. The force is integrated with a function that varies over the length `reach` near that end. The change
  /// of d^p is p d^(p-1), whose integral over d < reach is like that of d^p/reach.
  R displaced(const PanelPart<R>& part, const R& to_left, const R& to_right, const R& reach) const {
    const R d = singular_end == Side::left ? part.from_left + to_left : part.from_right + to_right;
    return 2 * end_error / std::max(d, reach);
  }
};

/// A part of the contact between two neighbouring singular points, as given by a solution.
template <Real R>
struct TractionSegment {
  SurfacePlace<R> left;
  SurfacePlace<R> right;
  R length;
  Surroundings<R> around;
  Power<R> left_power;  ///< power of t at the left end
  Power<R> right_power;
  /// Set if the profile's slope jumps by D, or the profile changes its polynomial, at an end with pressure on both
  /// sides. It returns q at the distance d from that end, in t = q + d^p g, p != 0, q = D/(jump of s), or in t = q log
  /// d + g, q = D/(pi (1 + s^2)), with analytic g [Bal16, section 3]. Null otherwise.
  std::function<R(const R&)> left_corner;
  std::function<R(const R&)> right_corner;
  R shear_ratio;
  /// Computes t at many places, given by their distances from both ends.
  std::function<void(std::span<const R>, std::span<const R>, std::span<R>)> tractions;
  /// Returns the estimated relative error of t at a place, given in the same way.
  std::function<R(const R&, const R&)> relative_error;
  R left_error = 0;  ///< estimated errors of the positions of the ends
  R right_error = 0;
};

/// A rule: int f t dx = sum forces[i] f, at the given distances from the part's ends.
template <Real R>
struct TractionNodes {
  std::vector<R> from_left;
  std::vector<R> from_right;
  std::vector<R> forces;

  void clear() {
    for (std::vector<R>* numbers : {&from_left, &from_right, &forces}) numbers->clear();
  }
};

template <Real R>
class PiecewiseTraction {
 public:
  /// `degree` is the largest degree of the profile's slope.
  explicit PiecewiseTraction(Elasticity elasticity, int degree = 0);

  /// Adds a segment. Segments must be added from left to right.
  void add(const TractionSegment<R>& segment);
  /// Adds a cell with a constant traction.
  void add(const SurfacePlace<R>& left, const SurfacePlace<R>& right, const R& length, const R& traction,
           const R& shear_ratio);
  /// Adds the traction of the same problem on a coarser mesh. The first one added is the finest.
  void add_coarser(PiecewiseTraction traction) { coarser_.push_back(std::move(traction)); }

  const Elasticity& elasticity() const { return elasticity_; }
  const std::vector<TractionPanel<R>>& panels() const { return panels_; }
  const std::vector<PiecewiseTraction>& coarser() const { return coarser_; }
  /// Returns the distance between the first and the last end of contact; 1 without contact.
  R width() const { return panels_.empty() ? R(1) : panels_.back().right - panels_.front().left; }
  /// Returns the panels of segment k, in the order in which segments were added.
  std::span<const TractionPanel<R>> segment(std::size_t k) const {
    const std::size_t end = k + 1 < segments_.size() ? segments_[k + 1] : panels_.size();
    return std::span(panels_).subspan(segments_[k], end - segments_[k]);
  }
  /// On cells errors are 1/N^rate, of averages at the surface 1/N^surface_rate.
  struct MeshRates {
    double rate = 2;
    double surface_rate = 2;
  };
  const MeshRates& mesh_rates() const { return mesh_rates_; }
  void set_mesh_rates(const MeshRates& rates) { mesh_rates_ = rates; }
  /// Returns t on a panel with constant t.
  const R& constant(const TractionPanel<R>& panel) const { return coefficients_[panel.first]; }
  /// Returns the number of nodes of every rule.
  std::size_t nodes_per_rule() const { return legendre_->size(); }
  /// Appends the nodes of a part, graded towards all singular points in it or beside it.
  void append_nodes(const TractionPanel<R>& panel, const PanelPart<R>& part, TractionNodes<R>& nodes) const;
  /// Appends the nodes of one rule for the whole panel. It is accurate if the poles of f are at least a panel's length
  /// away.
  void append_nodes(const TractionPanel<R>& panel, TractionNodes<R>& nodes) const;

 private:
  void add_panel(const TractionSegment<R>& segment, const GradedPanel<R>& part, const Power<R>& power);
  void append_rule(const TractionPanel<R>& panel, const PanelPart<R>& part, const GradedPanel<R>& of_part,
                   TractionNodes<R>& nodes) const;
  /// Returns the coefficients of Chebyshev's polynomials of 2y - 1, from values at `positions_`.
  std::vector<R> chebyshev_series(const std::vector<R>& values) const;
  void add_corner(const TractionSegment<R>& segment, const GradedPanel<R>& part);

  Elasticity elasticity_;
  std::size_t degree_;  ///< degree of g
  int rule_size_;
  std::vector<R> cosines_;                  ///< of k pi/2n, where n is the number of terms of a series
  std::vector<std::pair<R, R>> positions_;  ///< Chebyshev's points y, and 1 - y
  std::shared_ptr<JacobiRules<R>> rules_;
  const UnitRule<R>* legendre_;
  std::vector<TractionPanel<R>> panels_;
  std::vector<std::size_t> segments_;  ///< the first panel of each segment
  std::vector<R> coefficients_;
  std::vector<PiecewiseTraction> coarser_;
  MeshRates mesh_rates_;
};

}  // namespace steadyslide::numeric
