#include "numeric/periodic/periodic_images.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace steadyslide::numeric {
namespace {

using ComplexDouble = std::complex<double>;

/// Returns cot(pi v) - (1/v + 1/(v-1) + 1/(v+1))/pi and its derivative; |Re v| <= 1.
std::pair<ComplexDouble, ComplexDouble> distant_cotangent(const ComplexDouble& v) {
  const ComplexDouble square = v * v;
  if (std::norm(square) < 2) {
    // -(2/pi) sum_n (zeta(2n) - 1) v^(2n-1), zeta(2n) - 1 = sum_j j^-2n from j = 2 on
    static const std::vector<double> coefficients = [] {
      std::vector<double> made;
      for (int n = 1; n <= 36; ++n) {
        // The sum beyond 100 by Euler and Maclaurin.
        double sum = std::pow(100, 1 - 2 * n) / (2 * n - 1) + std::pow(100, -2 * n) / 2 +
                     n * std::pow(100, -2 * n - 1) / 6 -
                     n * (2 * n + 1) * (2 * n + 2) * std::pow(100, -2 * n - 3) / 360;
        for (int j = 99; j > 1; --j) sum += std::pow(j, -2 * n);
        made.push_back(sum);
      }
      return made;
    }();
    ComplexDouble power = 1, sum = 0, slope = 0;
    for (int n = 1; n <= 36; ++n, power *= square) {
      const double coefficient = coefficients[static_cast<std::size_t>(n - 1)];
      sum += coefficient * power;
      slope += (2 * n - 1) * coefficient * power;
    }
    return {-2 / std::numbers::pi * sum * v, -2 / std::numbers::pi * slope};
  }
  const ComplexDouble cotangent = 1.0 / std::tan(std::numbers::pi * v);
  ComplexDouble value = cotangent, slope = -std::numbers::pi * (1.0 + cotangent * cotangent);
  for (const int period : {-1, 0, 1}) {
    const ComplexDouble inverse = 1.0 / (v + static_cast<double>(period));
    value -= inverse / std::numbers::pi;
    slope += inverse * inverse / std::numbers::pi;
  }
  return {value, slope};
}

}  // namespace

PeriodicImages::PeriodicImages(const ContactProblem& problem, std::vector<SurfaceForces> tractions)
    : exact_period_(*problem.body().period()),
      period_(to_real<double>(exact_period_)),
      gamma_(to_real<double>(problem.elasticity().gamma())),
      tractions_(std::move(tractions)) {}

double PeriodicImages::periods_away(double x) const {
  const SurfaceForces& forces = tractions_.front();
  return std::round((x - forces.first - forces.width() / 2) / period_);
}

PeriodicImages::Stress PeriodicImages::at(std::size_t traction, double x, double z) const {
  const SurfaceForces& forces = tractions_[traction];
  ComplexDouble value, slope, value_t, slope_t;  // of C and C_t, in units of 1/L and 1/L^2
  double normal = 0, tangential = 0, size = 0;
  for (std::size_t i = 0; i < forces.normal.size(); ++i) {
    const double place = forces.middle(i / SurfaceForces::order) + forces.from_middle(i % SurfaceForces::order);
    const auto [cotangent, derivative] = distant_cotangent(ComplexDouble(place - x, -z) / period_);
    value += forces.normal[i] * cotangent;
    slope -= forces.normal[i] * derivative;
    value_t += forces.tangential[i] * cotangent;
    slope_t -= forces.tangential[i] * derivative;
    normal += forces.normal[i];
    tangential += forces.tangential[i];
    size += std::abs(forces.normal[i]) + std::abs(forces.tangential[i]);
  }
  const double depth = z / period_, shift = depth * (slope.real() - slope_t.imag());
  const std::array<double, 4> sums{value.imag() + 2 * value_t.real() + shift - 2 * gamma_ * normal,
                                   value.imag() - shift, -value_t.imag() - depth * (slope.imag() + slope_t.real()),
                                   value_t.imag() - value.real() - gamma_ * tangential};
  Stress result;
  const double error = 16 * (64 * epsilon<double>() * size + forces.normal_error + forces.tangential_error) / period_;
  for (std::size_t j = 0; j < 4; ++j) result[j] = {sums[j] / period_, error};
  return result;
}

}  // namespace steadyslide::numeric
