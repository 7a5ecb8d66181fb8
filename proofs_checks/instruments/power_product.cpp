#include "proofs_checks/instruments/power_product.hpp"

namespace steadyslide::proofs_checks {

PowerProduct PowerProduct::on(const std::vector<Rational>& points, std::vector<Exponent> exponents,
                              std::vector<Number> amplitudes) {
  PowerProduct product{numeric::to_real<Number>(points.front()), {}, std::move(exponents), std::move(amplitudes)};
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    product.lengths.push_back(numeric::to_real<Number>(points[k + 1] - points[k]));
  }
  return product;
}

}  // namespace steadyslide::proofs_checks
