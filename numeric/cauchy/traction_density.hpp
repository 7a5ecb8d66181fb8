#pragma once
// The traction of a Riemann-Hilbert form as a density for quadratures: on each segment in contact the powers of its two
// ends, and what is smooth beside them. At a wedge the constant, or the logarithm, is larger than a power that
// vanishes: there the power is 0.

#include "numeric/cauchy/density.hpp"
#include "numeric/riemann_hilbert/traction_representation.hpp"

namespace steadyslide::numeric {

/// On one segment in contact, in xi. The form has to outlive the density.
template <Real R>
PanelDensity<R> panel_density(const TractionRepresentation<R>& form, std::size_t segment);

/// On all segments in contact, left to right.
template <Real R>
PiecewiseDensity<R> traction_density(const TractionRepresentation<R>& form);

}  // namespace steadyslide::numeric
