#pragma once
// The operator of the sliding contact problem, applied to a traction given panel by panel [Bal16, (3)]:
//
//   A t = H t + s t,   H t(x) = (1/pi) PV int t(x')/(x'-x) dx'

#include <functional>
#include <vector>

#include "numeric/cauchy/density.hpp"
#include "numeric/number/estimate.hpp"
#include "numeric/quadrature/trapezoidal.hpp"

namespace steadyslide::numeric {

/// The unrelated ways to the principal value. GSL works in double only: std::invalid_argument at other precisions.
enum class Route { tanh_sinh, trapezoidal, gsl };

/// A t at one point, by its terms.
template <Real R>
struct SlidingTerms {
  R traction;           ///< t
  Estimate<R> hilbert;  ///< H t
  R friction;           ///< s t

  /// A t.
  Estimate<R> sum() const;
  /// |A t - slope| / max(|slope|, |s t|, |H t|, |t|). |t| is in the scale because the other three vanish together where
  /// s and the slope do.
  R residual(const R& slope) const;
};

template <Real R>
class SlidingOperator {
 public:
  /// s holds one value per panel.
  SlidingOperator(PiecewiseDensity<R> traction, std::vector<R> s, Route route);
  /// By samples that are there already; they have to outlive the operator. The error of their principal values is that
  /// of rounding: the rule has no estimate of its own.
  SlidingOperator(const trapezoidal::Grid<R>& grid, std::vector<R> s);
  SlidingOperator(trapezoidal::Grid<R>&& grid, std::vector<R> s) = delete;

  /// At a point inside a panel.
  SlidingTerms<R> at(const PanelPoint<R>& point) const;

 private:
  PiecewiseDensity<R> traction_;
  std::vector<R> s_;
  std::function<Estimate<R>(const PanelPoint<R>&)> hilbert_;
};

}  // namespace steadyslide::numeric
