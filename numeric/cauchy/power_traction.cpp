#include "numeric/cauchy/power_traction.hpp"

#include <memory>

namespace steadyslide::numeric {

template <Real R>
PiecewiseDensity<R> PowerTraction<R>::density() const {
  const auto shared = std::make_shared<const FundamentalSolution<R>>(weight);
  PiecewiseDensity<R> result;
  result.reserve(amplitudes.size());
  for (std::size_t k = 0; k < amplitudes.size(); ++k) {
    result.push_back({weight.panel(k), weight.powers()[k], weight.powers()[k + 1],
                      [shared, k, amplitude = amplitudes[k]](const Node<R>& node) {
                        return R(amplitude * shared->smooth_modulus(k, node));
                      }});
  }
  return result;
}

template struct PowerTraction<double>;
template struct PowerTraction<Real50>;
template struct PowerTraction<Real100>;

}  // namespace steadyslide::numeric
