#pragma once
// First quadrature route: Boost.Math's tanh-sinh rule, with the powers at the ends of a panel absorbed.
//
// On each half of a panel d = h v^{1/(1+lambda)} turns int_0^h d^lambda g(d) dd into h^{1+lambda}/(1+lambda) int_0^1 g
// dv: the integrand is bounded for any integrable power, and no part of the integral lies below the smallest number of
// the type. Principal values use t(x') - t(x) near x, and the corresponding logarithm.

#include "model/direction.hpp"
#include "numeric/number/estimate.hpp"
#include "numeric/quadrature/density.hpp"

namespace steadyslide::numeric::tanh_sinh {

/// Returns int t over one panel.
template <Real R>
Estimate<R> panel_integral(const PanelDensity<R>& density);

/// Returns an upper bound of int dd/d over the distances d, in panel lengths, at which panel_integral() evaluates a
/// density with this power at an end. If the density is t/d, an error of t that does not vanish at the end is
/// multiplied by this factor in the integral.
template <Real R>
R logarithm(const Power<R>& power);

/// Returns int t over all panels.
template <Real R>
Estimate<R> integral(const PiecewiseDensity<R>& density);

/// Returns H t = (1/pi) PV int t(x')/(x'-x) dx' at a point inside a panel.
template <Real R>
Estimate<R> hilbert(const PiecewiseDensity<R>& density, const PanelPoint<R>& at);

/// Returns the same integral at a distance d > 0 to the left of the first panel (Side::left) or to the right of the
/// last one.
template <Real R>
Estimate<R> cauchy(const PiecewiseDensity<R>& density, Side side, const R& distance);

}  // namespace steadyslide::numeric::tanh_sinh
