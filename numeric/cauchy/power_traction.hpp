#pragma once
// Tractions of the form t = amplitude_k |Y(x)| on panel k: what every closed form for a polynomial profile is.

#include <memory>

#include "numeric/cauchy/density.hpp"
#include "numeric/cauchy/fundamental_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
struct PowerTraction {
  FundamentalSolution<R> weight;
  std::vector<R> amplitudes;  ///< one per panel

  R operator()(std::size_t panel, const Node<R>& node) const { return amplitudes[panel] * weight.modulus(panel, node); }
  /// The same traction for the quadrature routes. It keeps its own copy of the weight.
  PiecewiseDensity<R> density() const {
    const auto shared = std::make_shared<const FundamentalSolution<R>>(weight);
    PiecewiseDensity<R> result;
    for (std::size_t k = 0; k < amplitudes.size(); ++k) {
      const auto smooth = [shared, k, amplitude = amplitudes[k]](const Node<R>& node) {
        return amplitude * shared->smooth_modulus(k, node);
      };
      result.push_back({weight.panel(k), weight.powers()[k], weight.powers()[k + 1], smooth});
    }
    return result;
  }
};

}  // namespace steadyslide::numeric
