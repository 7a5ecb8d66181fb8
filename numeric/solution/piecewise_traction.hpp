#pragma once
// The traction of a solution as all methods can give it: on each panel of the contact a power of the distance from one of
// its ends times a polynomial g,
//
//   t(x) = y^p g(y),   y = d/L,   d the distance from the panel's singular end, L its length;   t_t = r t, r a constant.
//
// Panels are no longer than their distance from the next singular point but their own end, so that g, analytic in the
// ellipse of Bernstein rho = 3 + sqrt 8, is its Chebyshev series up to degree n to 5.8^-n. Towards a place where t has a
// logarithm, or a constant beside its power, panels shrink by halves until what is left carries nothing. Cells are panels
// with a constant g. In the user's units.

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

/// A part of a panel: what lies left of it, its length, and what lies right of it; zeros are exact.
template <Real R>
struct PanelPart {
  R from_left;
  R length;
  R from_right;
  R beyond_left = infinity<R>();  ///< from its ends to what else an integrand is singular at, a pole beside the surface
  R beyond_right = infinity<R>();
};

template <Real R>
struct TractionPanel {
  SurfacePlace<R> left;
  SurfacePlace<R> right;
  R length;
  std::optional<Side> singular_end;  ///< where the power sits; y counts from the left without
  Power<R> power;
  const UnitRule<R>* rule;  ///< for y^p, its nodes counted from the singular end
  std::size_t first;        ///< of the Chebyshev coefficients of g
  std::size_t count;
  R shear_ratio;  ///< r
  R error;        ///< of t over the panel, estimated, relative
  R force_error;  ///< as places see it that are at least its length away: of the force on it,
  R shift;        ///< and by how much that may be displaced, a length
  R end_error;    ///< by how much its singular end may be displaced, estimated; 0 where it cannot be

  /// What a displaced end changes of the force at these distances from the ends of a part, relative, estimated, as a function
  /// sees it that varies over lengths of `reach` near that end: p d^(p-1) of d^p, which is as large over all d < reach as
  /// d^p/reach.
  R displaced(const PanelPart<R>& part, const R& to_left, const R& to_right, const R& reach) const {
    const R d = singular_end == Side::left ? part.from_left + to_left : part.from_right + to_right;
    return 2 * end_error / std::max(d, reach);
  }
};

/// A part of the contact between two neighbouring singular points, as a solution knows it.
template <Real R>
struct TractionSegment {
  SurfacePlace<R> left;
  SurfacePlace<R> right;
  R length;
  Surroundings<R> around;
  Power<R> left_power;  ///< of t
  Power<R> right_power;
  /// Where the profile's slope jumps by D, or changes its polynomial, at an end under pressure on both sides: q, at the
  /// distance d from that end, in t = q + d^p g, p != 0, q = D/(jump of s), or in t = q log d + g, q = D/(pi (1 + s^2)),
  /// with g analytic [Bal16, section 3]. Null elsewhere.
  std::function<R(const R&)> left_corner;
  std::function<R(const R&)> right_corner;
  R shear_ratio;
  /// t at many places, by their distances from both ends.
  std::function<void(std::span<const R>, std::span<const R>, std::span<R>)> tractions;
  /// Of t at a place, estimated, by the same.
  std::function<R(const R&, const R&)> relative_error;
  R left_error = 0;  ///< by how much the ends may be displaced, estimated
  R right_error = 0;
};

/// A rule: int f t dx = sum forces[i] f at the distances given from the part's ends.
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
  /// `degree`: of the profile's slope, at most.
  explicit PiecewiseTraction(Elasticity elasticity, int degree = 0);

  /// From left to right.
  void add(const TractionSegment<R>& segment);
  /// A cell with a constant traction.
  void add(const SurfacePlace<R>& left, const SurfacePlace<R>& right, const R& length, const R& traction,
           const R& shear_ratio, const R& error, const R& force_error, const R& shift);

  const Elasticity& elasticity() const { return elasticity_; }
  const std::vector<TractionPanel<R>>& panels() const { return panels_; }
  /// The panels of segment k, as added.
  std::span<const TractionPanel<R>> segment(std::size_t k) const {
    const std::size_t end = k + 1 < segments_.size() ? segments_[k + 1] : panels_.size();
    return std::span(panels_).subspan(segments_[k], end - segments_[k]);
  }
  /// t on a panel with a constant one.
  const R& constant(const TractionPanel<R>& panel) const { return coefficients_[panel.first]; }
  /// Nodes of every rule.
  std::size_t nodes_per_rule() const { return legendre_->size(); }
  /// Appends the nodes of a part, graded towards whatever is singular in it or beside it.
  void append_nodes(const TractionPanel<R>& panel, const PanelPart<R>& part, TractionNodes<R>& nodes) const;
  /// Those of one rule for the whole panel: right where f has its poles a panel's length away.
  void append_nodes(const TractionPanel<R>& panel, TractionNodes<R>& nodes) const;

 private:
  void add_panel(const TractionSegment<R>& segment, const GradedPanel<R>& part, const Power<R>& power);
  void append_rule(const TractionPanel<R>& panel, const PanelPart<R>& part, const GradedPanel<R>& of_part,
                   TractionNodes<R>& nodes) const;
  /// Coefficients of Chebyshev's polynomials of 2y - 1, from values at `positions_`.
  std::vector<R> chebyshev_series(const std::vector<R>& values) const;
  void add_corner(const TractionSegment<R>& segment, const GradedPanel<R>& part);

  Elasticity elasticity_;
  std::size_t degree_;  ///< of g
  int rule_size_;
  std::vector<R> cosines_;                  ///< of k pi/2n, n numbers of a series
  std::vector<std::pair<R, R>> positions_;  ///< Chebyshev's points y, and 1 - y
  std::shared_ptr<JacobiRules<R>> rules_;
  const UnitRule<R>* legendre_;
  std::vector<TractionPanel<R>> panels_;
  std::vector<std::size_t> segments_;  ///< the first panel of each
  std::vector<R> coefficients_;
};

}  // namespace steadyslide::numeric
