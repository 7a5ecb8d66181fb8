#pragma once
// Does a traction satisfy the contact problem? Measured with the trapezoidal route, in reduced quantities, for any
// solver.

#include <functional>
#include <vector>

#include "numeric/trapezoidal.hpp"

namespace steadyslide::numeric {

template <Real R>
class SurfaceCheck {
 public:
  /// t panel by panel, s on each panel, and psi'/c as a function of x.
  SurfaceCheck(PiecewiseDensity<R> traction, std::vector<R> s, std::function<R(const R&)> profile_slope);

  /// int t.
  R integral() const { return grid_.integral(); }
  /// max |A t - psi'/c| / max(|psi'/c|, |s t|, |H t|, |t|) over points of every panel, from 1e-6 of its length from one
  /// end to 1e-6 from the other. |t| is in the scale because the other three vanish together where s and psi' do.
  R equation() const;
  /// The largest t at those points.
  R highest_traction() const;
  /// The lowest reduced gap over `length` beyond the contact on that side; 0 at the contact itself.
  R lowest_gap(Side side, const R& length) const;

 private:
  std::vector<PanelPoint<R>> points() const;

  trapezoidal::Grid<R> grid_;
  std::vector<R> s_;
  std::function<R(const R&)> profile_slope_;
};

}  // namespace steadyslide::numeric
