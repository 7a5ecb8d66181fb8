#pragma once
// Does a traction satisfy the contact problem? Measured with the trapezoidal route, in reduced quantities, for any
// solver.

#include <functional>
#include <vector>

#include "numeric/quadrature/trapezoidal.hpp"

namespace steadyslide::numeric {

template <Real R>
class SurfaceCheck {
 public:
  using ProfileSlope = std::function<R(std::size_t panel, const Node<R>&)>;

  /// t panel by panel, s on each panel, and psi'/c, tilted as the indenter is.
  SurfaceCheck(PiecewiseDensity<R> traction, std::vector<R> s, ProfileSlope profile_slope);

  /// int t.
  R integral() const { return grid_.integral(); }
  /// The largest relative residual of A t = psi'/c (sliding_operator.hpp) over points of every panel, from 1e-6 of its
  /// length from one end to 1e-6 from the other.
  R equation() const;
  /// The largest t at those points.
  R highest_traction() const;
  /// u/c at the distance d beyond the end of panel k, where a gap begins, minus u/c at that end.
  R displacement(std::size_t k, Side end, const R& distance) const { return grid_.displacement(k, end, distance); }

 private:
  std::vector<PanelPoint<R>> points() const;

  trapezoidal::Grid<R> grid_;
  std::vector<R> s_;
  ProfileSlope profile_slope_;
};

}  // namespace steadyslide::numeric
