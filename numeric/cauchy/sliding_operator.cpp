#include "numeric/cauchy/sliding_operator.hpp"

#include <stdexcept>

#include "numeric/quadrature/gsl_quadrature.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/quadrature/trapezoidal.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
Estimate<R> hilbert(const PiecewiseDensity<R>& traction, const PanelPoint<R>& at, Route route) {
  using std::abs;
  switch (route) {
    case Route::tanh_sinh: return tanh_sinh::hilbert(traction, at);
    case Route::trapezoidal: {
      const R value = trapezoidal::Grid<R>(traction).hilbert(at);
      return {value, 100 * epsilon<R>() * (abs(value) + abs(traction[at.panel](at.node)))};
    }
    case Route::gsl:
      if constexpr (std::same_as<R, double>) return gsl::hilbert(traction, at);
      break;
  }
  throw std::invalid_argument("the GSL route works in double precision only");
}

}  // namespace

template <Real R>
Estimate<R> sliding_operator(const PiecewiseDensity<R>& traction, const std::vector<R>& s, const PanelPoint<R>& at,
                             Route route) {
  using std::abs;
  const R st = s.at(at.panel) * traction.at(at.panel)(at.node);
  return hilbert(traction, at, route) + Estimate<R>{st, 4 * epsilon<R>() * abs(st)};
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template Estimate<R> sliding_operator(const PiecewiseDensity<R>&, const std::vector<R>&, const PanelPoint<R>&, Route);
STEADYSLIDE_INSTANTIATE(double)
STEADYSLIDE_INSTANTIATE(Real50)
STEADYSLIDE_INSTANTIATE(Real100)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
