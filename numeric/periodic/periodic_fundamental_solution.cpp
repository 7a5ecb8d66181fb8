#include "numeric/periodic/periodic_fundamental_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
PeriodicFundamentalSolution<R>::PeriodicFundamentalSolution(const R& first, std::vector<R> arcs,
                                                            std::vector<Power<R>> powers)
    : arcs_(std::move(arcs)), powers_(std::move(powers)) {
  for (const R& arc : arcs_) {
    points_.push_back(first + period_);
    period_ += arc;
  }
  wave_number_ = pi<R>() / period_;
}

template <Real R>
R PeriodicFundamentalSolution<R>::ratio(const R& distance) const {
  // The smallest numbers of the type have few digits. So the sine is divided by its own argument.
  const R z = wave_number_ * distance;
  return z == 0 ? wave_number_ : R(wave_number_ * (sin(z) / z));
}

template <Real R>
R PeriodicFundamentalSolution<R>::modulus(std::size_t k, const R& from_left, const R& from_right, bool without_left,
                                          bool without_right) const {
  R product = 1;
  R logarithm = 0;  // a sum of logarithms costs less than powers in higher precision
  const auto multiply = [&](std::size_t j, const R& distance) {
    const R& p = powers_[j].value;
    if (p == 0) return;
    const bool left = without_left && j == k;
    const bool right = without_right && j == (k + 1) % size();
    R factor = left || right ? ratio(distance) : R(sin(wave_number_ * distance));
    // The distance the other way round, if it is not the one that was taken out.
    if (left && distance != from_left) factor *= distance / from_left;
    if (right && distance != from_right) factor *= distance / from_right;
    if constexpr (std::same_as<R, double>) {
      product *= pow(factor, p);
    } else {
      logarithm += p * log(factor);
    }
  };
  // Each point is reached the shorter way round, so that distances are sums of lengths and nothing cancels.
  std::size_t on_left = 0;
  R distance = from_left;
  for (; on_left < size() && 2 * distance <= period_; ++on_left) {
    const std::size_t j = (k + size() - on_left) % size();
    multiply(j, distance);
    distance += arcs_[(j + size() - 1) % size()];
  }
  distance = from_right;
  for (std::size_t i = 1; i + on_left <= size(); ++i) {
    const std::size_t j = (k + i) % size();
    multiply(j, distance);
    distance += arcs_[j];
  }
  if constexpr (std::same_as<R, double>) return product;
  return exp(logarithm);
}

STEADYSLIDE_INSTANTIATE_CLASS(PeriodicFundamentalSolution)

}  // namespace steadyslide::numeric
