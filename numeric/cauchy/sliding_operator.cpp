#include "numeric/cauchy/sliding_operator.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "numeric/quadrature/gsl_quadrature.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
Estimate<R> hilbert(const trapezoidal::Grid<R>& grid, const PanelPoint<R>& at) {
  const R value = grid.hilbert(at);
  return {value, 100 * epsilon<R>() * (abs(value) + abs(grid.density()[at.panel](at.node)))};
}

/// Returns H of a density as a function of the point. The function owns its data.
template <Real R>
std::function<Estimate<R>(const PanelPoint<R>&)> hilbert_by(const PiecewiseDensity<R>& traction, Route route) {
  switch (route) {
    case Route::tanh_sinh: return [traction](const PanelPoint<R>& at) { return tanh_sinh::hilbert(traction, at); };
    case Route::trapezoidal:
      return [grid = std::make_shared<const trapezoidal::Grid<R>>(traction)](const PanelPoint<R>& at) {
        return hilbert(*grid, at);
      };
    case Route::gsl:
      if constexpr (std::same_as<R, double>) {
        return [traction](const PanelPoint<R>& at) { return gsl::hilbert(traction, at); };
      }
  }
  throw std::invalid_argument("the GSL route works in double precision only");
}

}  // namespace

template <Real R>
Estimate<R> SlidingTerms<R>::sum() const {
  return hilbert + Estimate<R>{friction, 4 * epsilon<R>() * abs(friction)};
}

template <Real R>
R SlidingTerms<R>::residual(const R& slope) const {
  const R scale = max({abs(slope), abs(friction), abs(hilbert.value), abs(traction)});
  return abs(sum().value - slope) / scale;
}

template <Real R>
SlidingOperator<R>::SlidingOperator(PiecewiseDensity<R> traction, std::vector<R> s, Route route)
    : traction_(std::move(traction)), s_(std::move(s)), hilbert_(hilbert_by(traction_, route)) {}

template <Real R>
SlidingOperator<R>::SlidingOperator(const trapezoidal::Grid<R>& grid, std::vector<R> s)
    : traction_(grid.density()),
      s_(std::move(s)),
      hilbert_([&grid](const PanelPoint<R>& at) { return hilbert(grid, at); }) {}

template <Real R>
SlidingTerms<R> SlidingOperator<R>::at(const PanelPoint<R>& point) const {
  const R t = traction_.at(point.panel)(point.node);
  return {t, hilbert_(point), s_.at(point.panel) * t};
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template struct SlidingTerms<R>; \
  template class SlidingOperator<R>;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
