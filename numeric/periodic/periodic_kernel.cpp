#include "numeric/periodic/periodic_kernel.hpp"

namespace steadyslide::numeric {
namespace {

/// Returns a rule for int_0^1 y f(y) dy, if the poles of f are at least one length away.
template <Real R>
UnitRule<R> rule_of_cells() {
  const int points = static_cast<int>(-log(epsilon<R>()) / R(3)) + 4;
  return jacobi_rule<R>({R(1), R(2)}, {}, points);
}

/// Returns int int log u du du up to a linear function.
template <Real R>
R twice_integrated_logarithm(const R& u) {
  return u == 0 ? R(0) : R(u * u / 2 * (log(u) - R(3) / 2));
}

}  // namespace

template <Real R>
PeriodicKernel<R>::PeriodicKernel(const R& period, const R& gamma)
    : period_(period), wave_number_(pi<R>() / period), gamma_(gamma), rule_(rule_of_cells<R>()) {}

template <Real R>
R PeriodicKernel<R>::normal(const R& y) const {
  const R z = wave_number_ * abs(y);
  return -log(2 * wave_number_ * (z == 0 ? R(1) : R(sin(z) / z)));
}

template <Real R>
R PeriodicKernel<R>::normal_slope(const R& y) const {
  const R z = wave_number_ * y;
  if (z == 0) return 0;
  // (sin z - z cos z)/(z sin z). The numerator is z^3/3 - z^5/30 + ...
  R numerator = sin(z) - z * cos(z);
  if (abs(z) < 1) {
    R power = z * z * z / 6;
    numerator = 0;
    for (int k = 1; numerator == 0 || abs(power) > epsilon<R>() * abs(numerator); ++k) {
      numerator += 2 * k * power;
      power *= -z * z / ((2 * k + 2) * (2 * k + 3));
    }
  }
  return wave_number_ * numerator / (z * sin(z));
}

template <Real R>
template <class F>
R PeriodicKernel<R>::mean(const R& y, const R& h, const F& f) const {
  R sum = 0;
  for (std::size_t i = 0; i < rule_.size(); ++i)
    sum += rule_.weights[i] * (f(R(y + h * rule_.from_right[i])) + f(R(y - h * rule_.from_right[i])));
  return sum;
}

template <Real R>
R PeriodicKernel<R>::mean_of_logarithm(const R& y, const R& h) const {
  if (y >= 2 * h) return mean(y, h, [](const R& u) -> R { return log(u); });
  const auto F = [](const R& u) { return twice_integrated_logarithm<R>(abs(u)); };
  return (F(y + h) - 2 * F(y) + F(y - h)) / (h * h);
}

template <Real R>
R PeriodicKernel<R>::mean_of_cells(const R& y, const R& h) const {
  const R near = abs(y), far = period_ - near;
  if (near > far) return mean_of_logarithm(near, h) - mean_of_logarithm(far, h) + mean_of_cells(far, h);
  return mean(near, h, [this](const R& u) { return normal(u); });
}

STEADYSLIDE_INSTANTIATE_CLASS(PeriodicKernel)

}  // namespace steadyslide::numeric
