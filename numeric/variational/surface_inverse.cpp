#include "numeric/variational/surface_inverse.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace steadyslide::numeric::variational {
namespace {

/// Each kind of cells costs a transform: values of s that are close share one.
constexpr std::size_t most_kinds = 4;

/// Representative values: those that occur, or the means of most_kinds groups of them by angle.
std::vector<double> representatives(std::vector<double> s) {
  s.erase(std::unique(s.begin(), s.end()), s.end());  // neighbours: few are left to sort
  std::sort(s.begin(), s.end());
  s.erase(std::unique(s.begin(), s.end()), s.end());
  if (s.size() <= most_kinds) return s;
  const double low = std::atan(s.front());
  const double width = (std::atan(s.back()) - low) / most_kinds;
  std::vector<double> result;
  for (std::size_t k = 0; k < most_kinds; ++k) {
    result.push_back(std::tan(low + (static_cast<double>(k) + 0.5) * width));
  }
  return result;
}

/// Few lengths that are fast: four in an octave, so that plans and symbols are shared.
std::size_t circle_length(std::size_t cells) {
  const std::size_t least = std::max<std::size_t>(cells + cells / 8, 16);
  const std::size_t octave = std::bit_floor(least);
  for (const std::size_t quarters : {4U, 5U, 6U}) {
    if (octave / 4 * quarters >= least) return octave / 4 * quarters;
  }
  return 2 * octave;
}

}  // namespace

SurfaceInverse::SurfaceInverse(const GalerkinOperator& influence, double length)
    : influence_(influence), length_(length), kind_of_(influence.size()), pressures_(influence.size()) {
  std::vector<double> s = influence.friction().whole;
  for (double& value : s) value /= length;
  values_ = representatives(s);
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (i > 0 && s[i] == s[i - 1]) {
      kind_of_[i] = kind_of_[i - 1];
      continue;
    }
    const auto nearest = std::min_element(values_.begin(), values_.end(), [&](double a, double b) {
      return std::abs(std::atan(a) - std::atan(s[i])) < std::abs(std::atan(b) - std::atan(s[i]));
    });
    kind_of_[i] = static_cast<unsigned char>(nearest - values_.begin());
  }
}

std::vector<std::complex<double>> SurfaceInverse::reciprocal(double s, const Fourier& fourier) const {
  const CellFriction& friction = influence_.friction();
  const bool at_end = !friction.at_end.empty() && std::abs(s) > strong_friction;
  const double rest = at_end ? friction.sign * 0.5 : 0;
  std::vector<std::complex<double>> result = influence_.spectrum(at_end, fourier);
  const auto n = static_cast<double>(fourier.size());
  for (std::size_t k = 0; k < result.size(); ++k) {
    const double cot = k == 0 ? 0 : 1 / std::tan(std::numbers::pi * static_cast<double>(k) / n);
    // The symbol of sum over the cells before, half of the cell itself: -i h/2 cot(theta/2).
    const std::complex<double> symbol = result[k] + s * length_ * std::complex(rest, -cot / 2);
    result[k] = std::conj(symbol) / std::norm(symbol);
  }
  return result;
}

void SurfaceInverse::restrict_to(std::vector<CellRange> zones) {
  zones_.clear();
  for (const CellRange& cells : zones) {
    const std::size_t length = circle_length(cells.count);
    Circle& circle = circles_.try_emplace(length, length).first->second;
    Zone& zone = zones_.emplace_back(Zone{cells, &circle, {}});
    for (std::size_t i = cells.first; i < cells.first + cells.count; ++i) {
      if (std::find(zone.kinds.begin(), zone.kinds.end(), kind_of_[i]) == zone.kinds.end())
        zone.kinds.push_back(kind_of_[i]);
    }
    for (const unsigned char kind : zone.kinds) {
      if (!circle.reciprocals.contains(kind)) circle.reciprocals[kind] = reciprocal(values_[kind], circle.fourier);
    }
  }
}

void SurfaceInverse::apply(std::span<const double> r, std::span<double> p) {
  for (const Zone& zone : zones_) {
    const Fourier& fourier = zone.circle->fourier;
    const std::span<double> values = fourier.values();
    const auto [first, count] = zone.cells;
    std::copy_n(r.begin() + static_cast<std::ptrdiff_t>(first), count, values.begin());
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(count), values.end(), 0);
    fourier.forward();
    for (const unsigned char kind : zone.kinds) {
      const std::vector<std::complex<double>>& reciprocal = zone.circle->reciprocals.at(kind);
      if (kind == zone.kinds.front()) {
        fourier.convolve(reciprocal, p.subspan(first, count));
        continue;
      }
      fourier.convolve(reciprocal, std::span(pressures_).first(count));
      for (std::size_t i = 0; i < count; ++i) {
        if (kind_of_[first + i] == kind) p[first + i] = pressures_[i];
      }
    }
  }
}

}  // namespace steadyslide::numeric::variational
