#pragma once
// Third quadrature route, in double: GSL's adaptive rules for algebraic end singularities (QAWS) and for principal
// values (QAWC). One rule cannot have both weights. So a principal value is computed by QAWC around the point and by
// QAWS on the rest. `convergence` is GSL's own status. GSL's error estimate can be smaller than the true error.

#include "numeric/number/estimate.hpp"
#include "numeric/quadrature/density.hpp"

namespace steadyslide::numeric::gsl {

/// Returns int t over one panel.
Estimate<double> panel_integral(const PanelDensity<double>& density);

/// Returns int t over all panels.
Estimate<double> integral(const PiecewiseDensity<double>& density);

/// Returns H t = (1/pi) PV int t(x')/(x'-x) dx' at a point inside a panel.
Estimate<double> hilbert(const PiecewiseDensity<double>& density, const PanelPoint<double>& at);

}  // namespace steadyslide::numeric::gsl
