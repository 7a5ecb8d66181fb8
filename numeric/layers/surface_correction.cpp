#include "numeric/layers/surface_correction.hpp"

#include <map>
#include <mutex>

#include "numeric/layers/body_kernel.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
class LayeredCorrection : public SurfaceCorrection<R> {
 public:
  LayeredCorrection(const ContactProblem& problem, const R& reach)
      : symbols_(problem), reach_(reach), kernel_(symbols_, reach) {
    // 1 - W decreases like exp(-2kh). Given symbols end at a wave number, and N oscillates with it.
    const std::vector<Layer>& layers = problem.body().layers();
    strip_ = layers.empty() ? R(4 / symbols_.last_wave_number()) : R(2 * to_real<R>(layers.front().thickness));
  }

  R normal(const R& y) const override { return kernel(y).normal().at(y); }
  R normal_slope(const R& y) const override { return kernel(y).normal_slope().at(y); }
  R coupling(const R& y) const override { return kernel(y).coupling().at(y); }
  R coupling_slope(const R& y) const override { return kernel(y).coupling_slope().at(y); }
  R radius(const R& y) const override { return sqrt(R(y * y + strip_ * strip_)); }
  std::pair<R, R> symbols(const R& k) const override {
    const SymbolValues<R> values = symbols_.at(k);
    return {values.normal, symbols_.gamma() == 0 ? R(1) : R(values.coupling / symbols_.gamma())};
  }
  bool is_absolute() const override { return kernel_.is_absolute(); }

 private:
  /// Returns the kernel for a place; far places make it longer.
  const BodyKernel<R>& kernel(const R& y) const {
    if (abs(y) <= reach_) return kernel_;
    const std::lock_guard lock(making_);
    R reach = reach_;
    while (reach < abs(y)) reach *= 4;
    return far_.try_emplace(reach, symbols_, reach).first->second;
  }

  BodySymbols<R> symbols_;
  R reach_;
  BodyKernel<R> kernel_;
  R strip_;
  mutable std::mutex making_;
  mutable std::map<R, BodyKernel<R>> far_;  ///< by reach
};

/// -log|y| + N(y) = -log|sin(pi y/L)| + a constant. T subtracts the mean of s p, so that u has the period L.
template <Real R>
class PeriodicCorrection : public SurfaceCorrection<R> {
 public:
  explicit PeriodicCorrection(const ContactProblem& problem)
      : period_(to_real<R>(*problem.body().period())),
        wave_number_(pi<R>() / period_),
        gamma_(to_real<R>(problem.elasticity().gamma())) {}

  R normal(const R& y) const override {
    const R a = abs(wave_number_ * y);
    return a == 0 ? R(0) : R(log(a / sin(a)));
  }
  R normal_slope(const R& y) const override {
    const R a = wave_number_ * y;
    if (abs(a) >= R(1)) return wave_number_ * (1 / a - cos(a) / sin(a));
    // (sin a - a cos a)/(a sin a) with the series of the numerator, sum of 2n (-1)^(n+1) a^(2n+1)/(2n+1)!.
    R term = a * a / 3, sum = term;
    for (int n = 2; abs(term) > epsilon<R>() * abs(sum); ++n) {
      term *= -a * a / (2 * n * (2 * n + 1)) * n / (n - 1);
      sum += term;
    }
    return a == 0 ? R(0) : R(wave_number_ * sum / sin(a));
  }
  R coupling(const R& y) const override { return gamma_ * wave_number_ * y; }
  R coupling_slope(const R&) const override { return gamma_ * wave_number_; }
  R radius(const R& y) const override { return period_ - abs(y); }
  std::pair<R, R> symbols(const R&) const override { return {R(1), R(1)}; }
  std::optional<R> period() const override { return period_; }

 private:
  R period_;
  R wave_number_;
  R gamma_;
};

}  // namespace

template <Real R>
std::shared_ptr<const SurfaceCorrection<R>> surface_correction(const ContactProblem& problem, const R& reach) {
  if (problem.body().is_half_plane()) return nullptr;
  if (problem.body().period()) return std::make_shared<PeriodicCorrection<R>>(problem);
  return std::make_shared<LayeredCorrection<R>>(problem, reach);
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template std::shared_ptr<const SurfaceCorrection<R>> surface_correction(const ContactProblem&, const R&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
