// What integrals of the pressures on cells add to a sample.

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "numeric/variational/variational_solution.hpp"

namespace steadyslide::numeric {
namespace {

/// int log|y| dy
double logarithm_integral(double y) { return y == 0 ? 0 : y * std::log(std::abs(y)) - y; }

/// Values at the middles of equal cells on [-1/2, 1/2], joined by straight lines.
double interpolated(const std::vector<double>& values, double xi) {
  const double place = (xi + 0.5) * static_cast<double>(values.size()) - 0.5;
  const std::size_t i = place <= 0 ? 0 : std::min(static_cast<std::size_t>(place), values.size() - 2);
  const double part = std::clamp(place - static_cast<double>(i), 0.0, 1.0);
  return values[i] + part * (values[i + 1] - values[i]);
}

}  // namespace

Estimate<double> VariationalSolution::height(const Rational& x) const {
  const double profile = to_real<double>(variational::profile_above_middle(problem_, x));
  const double tilted = height_ * state().tilt * mesh().place(x);
  const double change = height_ * (state().tilt - found_.coarse.found.state.tilt) * mesh().place(x);
  return Estimate<double>{profile + tilted, std::abs(change) + 1e-15 * (std::abs(profile) + std::abs(tilted))} -
         at(x).gap.value_or(Estimate<double>{});
}

Estimate<double> VariationalSolution::rise_beyond(double xi) const {
  const double end = xi < 0 ? mesh().edges().front() : mesh().edges().back();
  double sum = 0;
  for (const Run& run : runs_) {
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const auto integral = [&](double place) {
        return logarithm_integral(mesh().right(i) - place) - logarithm_integral(mesh().left(i) - place);
      };
      sum += state().pressure[i] * (integral(xi) - integral(end));
    }
  }
  // u = -(c/pi) int t log|x'-x| dx' and a constant.
  const double rise = height_ / std::numbers::pi * sum;
  return {rise, std::abs(rise) * estimated_error().traction + 1e-15 * height_};
}

std::vector<double> VariationalSolution::shear_transform(const std::vector<double>& traction) const {
  // (1/pi) sum_j t_j log|(j - i + 1/2)/(j - i - 1/2)|: a convolution.
  const std::size_t n = traction.size();
  const std::size_t size = std::bit_ceil(2 * n);
  const variational::Fourier fourier(size);
  const std::span<double> values = fourier.values();
  std::fill(values.begin(), values.end(), 0.0);
  for (std::size_t m = 1; m < n; ++m) {
    const auto d = static_cast<double>(m);
    values[size - m] = std::log((d + 0.5) / (d - 0.5)) / std::numbers::pi;
    values[m] = -values[size - m];
  }
  fourier.forward();
  const std::vector<std::complex<double>> kernel(fourier.modes().begin(), fourier.modes().end());
  std::fill(values.begin(), values.end(), 0.0);
  const std::vector<Rational>& jumps = problem_.friction().jumps();
  std::size_t piece = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double middle = (static_cast<double>(i) + 0.5) / static_cast<double>(n) - 0.5;
    while (piece < jumps.size() && mesh().place(jumps[piece]) <= middle) ++piece;
    values[i] = to_real<double>(problem_.shear_ratio(piece)) * traction[i];
  }
  fourier.forward();
  std::vector<double> result(n);
  fourier.convolve(kernel, result);
  return result;
}

TwoSided<double> VariationalSolution::shear_slope(double xi, const TwoSided<double>& traction) const {
  const double c = to_real<double>(problem_.elasticity().compliance());
  const double gamma = to_real<double>(problem_.elasticity().gamma());
  if (xi < mesh().edges().front() || xi > mesh().edges().back()) {
    double sum = 0;
    std::size_t piece = 0;
    const std::vector<Rational>& jumps = problem_.friction().jumps();
    for (const Run& run : runs_) {
      for (std::size_t i = run.begin; i < run.end; ++i) {
        while (piece < jumps.size() && mesh().place(jumps[piece]) <= mesh().centre(i)) ++piece;
        sum += to_real<double>(problem_.shear_ratio(piece)) * traction_[i] *
               std::log(std::abs((mesh().right(i) - xi) / (mesh().left(i) - xi)));
      }
    }
    const double slope = c / std::numbers::pi * sum;
    const Estimate<double> estimate{slope, std::abs(slope) * estimated_error().traction};
    return {estimate, estimate};
  }
  const auto& [fine, coarse] =
      shear_transforms_([this] { return std::pair(shear_transform(traction_), shear_transform(coarse_traction_)); });
  const double here = interpolated(fine, xi);
  const double cell = mesh().length(0);
  const double change =
      std::max(std::abs(here - interpolated(fine, xi - cell)), std::abs(here - interpolated(fine, xi + cell)));
  const Estimate<double> transform{here, std::max(std::abs(here - interpolated(coarse, xi)), change / 2)};
  return {c * (transform + gamma * traction.left), c * (transform + gamma * traction.right)};
}

DetailedSample<double> VariationalSolution::details_at(const Rational& x) const {
  DetailedSample<double> result{at(x), {}, {}, {}, {}};
  const double xi = mesh().place(x);
  const Indenter& indenter = problem_.indenter();
  const bool on_left = x < indenter.left();
  const bool beyond = on_left || x > indenter.right();
  const Estimate<double>& origin = height_at_origin_([this] { return height(problem_.origin_of_displacement()); });
  result.displacement = height(beyond ? (on_left ? indenter.left() : indenter.right()) : x) - origin;
  if (beyond) result.displacement += rise_beyond(xi);
  if (!beyond) result.friction = {problem_.friction().piece(x, Side::left), problem_.friction().piece(x, Side::right)};
  result.cumulative_load = load_before(xi);
  result.shear_slope = shear_slope(xi, result.traction);
  return result;
}

std::vector<DetailedSample<double>> VariationalSolution::detailed_samples(int count) const {
  std::vector<DetailedSample<double>> result;
  for (const Rational& x : sampled_places(count)) result.push_back(details_at(x));
  return result;
}

}  // namespace steadyslide::numeric
