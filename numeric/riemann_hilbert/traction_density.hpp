#pragma once
// The traction of a Riemann-Hilbert form as a density for quadratures: on each segment in contact, the powers of its
// two ends and a smooth factor. At a wedge, if the power vanishes, the constant or the logarithm is larger; then the
// density has power 0 there.

#include "numeric/quadrature/density.hpp"
#include "numeric/riemann_hilbert/traction_representation.hpp"

namespace steadyslide::numeric {

/// Returns the density on one segment in contact, in xi. The form must outlive the density.
template <Real R>
PanelDensity<R> panel_density(const TractionRepresentation<R>& form, std::size_t segment);

/// Returns the densities on all segments in contact, from left to right.
template <Real R>
PiecewiseDensity<R> traction_density(const TractionRepresentation<R>& form);

}  // namespace steadyslide::numeric
