#pragma once
// Names that claims and instruments take from the numeric layer: numbers, exact data converted to them, tractions on
// panels, and the two quadrature rules that are applied to every traction.

#include "numeric/number/polynomial.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/quadrature/trapezoidal.hpp"

namespace steadyslide::proofs_checks {

using numeric::coefficients_of;
using numeric::cos_pi_alpha;
using numeric::Estimate;
using numeric::Node;
using numeric::PanelDensity;
using numeric::PanelPoint;
using numeric::PiecewiseDensity;
using numeric::Real;
using numeric::Real100;
using numeric::Real50;
using numeric::to_real;
using numeric::value_of;
namespace tanh_sinh = numeric::tanh_sinh;
namespace trapezoidal = numeric::trapezoidal;

/// The type that holds every number of the numeric layer exactly.
using Number = Real100;

}  // namespace steadyslide::proofs_checks
