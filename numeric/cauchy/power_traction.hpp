#pragma once
// Tractions of the form t = amplitude_k |Y(x)| on panel k: what every closed form for a polynomial profile is.

#include "numeric/cauchy/density.hpp"
#include "numeric/cauchy/fundamental_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
struct PowerTraction {
  FundamentalSolution<R> weight;
  std::vector<R> amplitudes;  ///< one per panel

  R operator()(std::size_t panel, const Node<R>& node) const { return amplitudes[panel] * weight.modulus(panel, node); }
  /// The same traction for the quadrature routes. It keeps its own copy of the weight.
  PiecewiseDensity<R> density() const;
};

}  // namespace steadyslide::numeric
