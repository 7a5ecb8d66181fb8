#pragma once
// Tractions of the form t = amplitude_k |Y(x)| on panel k. All closed forms for polynomial profiles have this form.

#include <memory>

#include "numeric/cauchy/fundamental_solution.hpp"
#include "numeric/quadrature/density.hpp"

namespace steadyslide::numeric {

template <Real R>
struct PowerTraction {
  FundamentalSolution<R> weight;
  std::vector<R> amplitudes;  ///< one per panel

  R operator()(std::size_t panel, const Node<R>& node) const { return amplitudes[panel] * weight.modulus(panel, node); }
  /// Computes t at many points of a panel, given by their distances from its ends (FundamentalSolution::moduli).
  void operator()(std::size_t panel, std::span<const R> from_left, std::span<const R> from_right,
                  std::span<R> values) const {
    weight.moduli(panel, from_left, from_right, values);
    for (R& value : values) value *= amplitudes[panel];
  }
  /// Returns the same traction for the quadrature routes, with its own copy of the weight.
  PiecewiseDensity<R> density() const {
    const auto shared = std::make_shared<const FundamentalSolution<R>>(weight);
    PiecewiseDensity<R> result;
    for (std::size_t k = 0; k < amplitudes.size(); ++k) {
      const auto smooth = [shared, k, amplitude = amplitudes[k]](const Node<R>& node) {
        return amplitude * shared->smooth_modulus(k, node);
      };
      result.push_back({weight.panel(k), weight.powers()[k], weight.powers()[k + 1], smooth});
    }
    if (result.size() == 1) result.front().is_constant = true;
    return result;
  }
};

}  // namespace steadyslide::numeric
