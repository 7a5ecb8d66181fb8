#pragma once
// Does a traction satisfy the contact problem? By the trapezoidal route, in reduced quantities.

#include <algorithm>

#include "numeric/cauchy/sliding_operator.hpp"

namespace steadyslide::numeric {

template <Real R>
class SurfaceCheck {
 public:
  using ProfileSlope = std::function<R(std::size_t panel, const Node<R>&)>;

  /// t panel by panel, s on each panel, and psi'/c, tilted as the indenter is.
  SurfaceCheck(PiecewiseDensity<R> traction, std::vector<R> s, ProfileSlope profile_slope)
      : grid_(std::move(traction)), s_(std::move(s)), profile_slope_(std::move(profile_slope)) {}

  /// int t.
  R integral() const { return grid_.integral(); }
  /// The largest relative residual of A t = psi'/c (sliding_operator.hpp) over points of every panel, from 1e-6 of its
  /// length from one end to 1e-6 from the other.
  R equation() const {
    const SlidingOperator<R> A(grid_, s_);
    R worst = 0;
    for (const PanelPoint<R>& point : points()) {
      worst = std::max(worst, A.at(point).residual(profile_slope_(point.panel, point.node)));
    }
    return worst;
  }
  /// The largest t at those points.
  R highest_traction() const {
    R highest = -infinity<R>();
    for (const PanelPoint<R>& point : points()) {
      highest = std::max(highest, grid_.density()[point.panel](point.node));
    }
    return highest;
  }
  /// u/c at the distance d beyond the end of panel k, where a gap begins, minus u/c at that end.
  R displacement(std::size_t k, Side end, const R& distance) const { return grid_.displacement(k, end, distance); }

 private:
  std::vector<PanelPoint<R>> points() const {
    std::vector<PanelPoint<R>> result;
    for (std::size_t k = 0; k < grid_.density().size(); ++k) {
      // Numerators over 10^6: exact at every precision.
      for (const int fraction : {1, 100, 10'000, 250'000, 500'000, 800'000, 990'000, 999'900, 999'999}) {
        result.push_back(grid_.midpoint_near(k, R(fraction) / 1'000'000));
      }
    }
    return result;
  }

  trapezoidal::Grid<R> grid_;
  std::vector<R> s_;
  ProfileSlope profile_slope_;
};

}  // namespace steadyslide::numeric
