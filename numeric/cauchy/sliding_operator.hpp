#pragma once
// The operator of the sliding contact problem, applied to a traction given panel by panel [Bal16, (3)]:
//
//   A t = H t + s t,   H t(x) = (1/pi) PV int t(x')/(x'-x) dx'

#include <functional>
#include <vector>

#include "numeric/number/estimate.hpp"
#include "numeric/quadrature/density.hpp"
#include "numeric/quadrature/trapezoidal.hpp"

namespace steadyslide::numeric {

/// Independent methods for the principal value. GSL works in double only; other precisions throw std::invalid_argument.
enum class Route { tanh_sinh, trapezoidal, gsl };

/// The terms of A t at one point.
template <Real R>
struct SlidingTerms {
  R traction;           ///< t
  Estimate<R> hilbert;  ///< H t
  R friction;           ///< s t

  /// Returns A t.
  Estimate<R> sum() const;
  /// Returns |A t - slope| / max(|slope|, |s t|, |H t|, |t|). The scale contains |t| because the other three are all
  /// zero if s and the slope are.
  R residual(const R& slope) const;
};

template <Real R>
class SlidingOperator {
 public:
  /// s holds one value per panel.
  SlidingOperator(PiecewiseDensity<R> traction, std::vector<R> s, Route route);
  /// Uses existing samples, which must outlive the operator. The error of their principal values is the rounding error:
  /// the rule has no error estimate.
  SlidingOperator(const trapezoidal::Grid<R>& grid, std::vector<R> s);
  SlidingOperator(trapezoidal::Grid<R>&& grid, std::vector<R> s) = delete;

  /// Returns the terms at a point inside a panel.
  SlidingTerms<R> at(const PanelPoint<R>& point) const;

 private:
  PiecewiseDensity<R> traction_;
  std::vector<R> s_;
  std::function<Estimate<R>(const PanelPoint<R>&)> hilbert_;
};

}  // namespace steadyslide::numeric
