#pragma once
// Third quadrature route, in double: GSL's adaptive rules for algebraic end singularities (QAWS) and for principal
// values (QAWC). Their weights do not combine, so a principal value is QAWC around the point and QAWS on what is left.
// GSL's own status comes back as `convergence`; its error estimate can be below its true error.

#include "numeric/cauchy/density.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric::gsl {

/// int t over one panel.
Estimate<double> panel_integral(const PanelDensity<double>& density);

/// int t over all panels.
Estimate<double> integral(const PiecewiseDensity<double>& density);

/// H t = (1/pi) PV int t(x')/(x'-x) dx' at a point inside a panel.
Estimate<double> hilbert(const PiecewiseDensity<double>& density, const PanelPoint<double>& at);

}  // namespace steadyslide::numeric::gsl
