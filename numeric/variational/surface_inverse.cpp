#include "numeric/variational/surface_inverse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyslide::numeric::variational {
namespace {

/// Each zone costs a transform: values of s that are close share one.
constexpr std::size_t most_zones = 4;

/// Representative values: those that occur, or the means of most_zones groups of them by angle.
std::vector<double> representatives(std::vector<double> s) {
  s.erase(std::unique(s.begin(), s.end()), s.end());  // neighbours: few are left to sort
  std::sort(s.begin(), s.end());
  s.erase(std::unique(s.begin(), s.end()), s.end());
  if (s.size() <= most_zones) return s;
  const double low = std::atan(s.front());
  const double width = (std::atan(s.back()) - low) / most_zones;
  std::vector<double> result;
  for (std::size_t k = 0; k < most_zones; ++k) {
    result.push_back(std::tan(low + (static_cast<double>(k) + 0.5) * width));
  }
  return result;
}

}  // namespace

SurfaceInverse::SurfaceInverse(const GalerkinOperator& influence, double length)
    : zone_of_(influence.size()), fourier_(fast_length(influence.size() + influence.size() / 8)) {
  std::vector<double> s = influence.friction().whole;
  for (double& value : s) value /= length;
  const std::vector<double> values = representatives(s);
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (i > 0 && s[i] == s[i - 1]) {
      zone_of_[i] = zone_of_[i - 1];
      continue;
    }
    const auto nearest = std::min_element(values.begin(), values.end(), [&](double a, double b) {
      return std::abs(std::atan(a) - std::atan(s[i])) < std::abs(std::atan(b) - std::atan(s[i]));
    });
    zone_of_[i] = static_cast<unsigned char>(nearest - values.begin());
  }

  const auto n = static_cast<double>(fourier_.size());
  modes_.resize(fourier_.modes().size());
  std::vector<double> cot(modes_.size());
  for (std::size_t k = 1; k < cot.size(); ++k) cot[k] = 1 / std::tan(std::numbers::pi * static_cast<double>(k) / n);
  for (const double value : values) {
    std::vector<std::complex<double>>& reciprocal = reciprocals_.emplace_back();
    const bool at_end = !influence.friction().at_end.empty() && std::abs(value) > strong_friction;
    const double rest = at_end ? influence.friction().sign * 0.5 : 0;
    const std::vector<std::complex<double>> logarithm = influence.spectrum(at_end, fourier_);
    for (std::size_t k = 0; k < logarithm.size(); ++k) {
      // The symbol of sum over the cells before, half of the cell itself: -i h/2 cot(theta/2).
      const std::complex<double> symbol = logarithm[k] + value * length * std::complex(rest, -cot[k] / 2);
      reciprocal.push_back(std::conj(symbol) / (std::norm(symbol) * n));
    }
  }
}

void SurfaceInverse::apply(std::span<const double> r, std::span<double> p) {
  const std::span<double> values = fourier_.values();
  const std::span<std::complex<double>> modes = fourier_.modes();
  std::copy(r.begin(), r.end(), values.begin());
  std::fill(values.begin() + static_cast<std::ptrdiff_t>(r.size()), values.end(), 0);
  fourier_.forward();
  if (reciprocals_.size() > 1) std::copy(modes.begin(), modes.end(), modes_.begin());
  for (std::size_t zone = 0; zone < reciprocals_.size(); ++zone) {
    const std::complex<double>* const from = reciprocals_.size() > 1 ? modes_.data() : modes.data();
    for (std::size_t k = 0; k < modes.size(); ++k) modes[k] = from[k] * reciprocals_[zone][k];
    fourier_.backward();
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (zone_of_[i] == zone) p[i] = values[i];
    }
  }
}

}  // namespace steadyslide::numeric::variational
