#pragma once
// prod d_j^{p_j} over distances d_j >= 0, factor by factor: in double by powers, above by one exponential of a sum of
// logarithms.

#include <numbers>

#include "numeric/number/power.hpp"

namespace steadyslide::numeric {

template <Real R>
class DistanceProduct;

/// Those of R, and of the digits that are served with it: with ten to spare.
template <Real R>
inline constexpr int all_bits = std::numeric_limits<R>::digits;
template <Real R>
inline constexpr int served_bits = static_cast<int>(digits_served<R> / (std::numbers::ln2 / std::numbers::ln10)) + 11;

template <>
class DistanceProduct<double> {
 public:
  explicit DistanceProduct(int /*bits*/) {}
  void multiply(double distance, const Power<double>& power) { value_ *= std::pow(distance, power.value); }
  void set_one() { value_ = 1; }
  double value() const { return value_; }

 private:
  double value_ = 1;
};

#ifndef STEADYSLIDE_DOUBLE_ONLY
template <Real R>
class DistanceProduct {
 public:
  /// So many bits are worked with (elementary.hpp).
  explicit DistanceProduct(int bits) : product_(bits) {}
  void multiply(const R& distance, const Power<R>& power) {
    product_.multiply(distance.backend().data(), power.value.backend().data());
  }
  void set_one() { product_.set_one(); }
  R value() const {
    R result;
    product_.value(result.backend().data());
    return result;
  }

 private:
  elementary::PowerProduct product_;
};
#endif

}  // namespace steadyslide::numeric
