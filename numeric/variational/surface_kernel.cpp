#include "numeric/variational/surface_kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace steadyslide::numeric::variational {
namespace {

/// Returns int log|u| du.
template <class T>
T once(T u) {
  return u == 0 ? 0 : u * (std::log(std::abs(u)) - 1);
}

/// Returns int int log|u| du du up to a linear function, which cancels in second differences. These also lose digits.
long double twice(long double u) { return u == 0 ? 0 : u * u / 2 * (std::log(std::abs(u)) - 1.5L); }

// Gauss-Legendre with eight points on [-1, 1], abscissae > 0: [AS, table 25.4].
constexpr std::array<std::pair<double, double>, 4> gauss{{{0.1834346424956498049, 0.3626837833783619830},
                                                          {0.5255324099163289858, 0.3137066458778872873},
                                                          {0.7966664774136267396, 0.2223810344533744705},
                                                          {0.9602898564975362317, 0.1012285362903762591}}};

template <class F>
double mean(double a, double b, const F& f) {
  const double centre = (a + b) / 2;
  const double half = (b - a) / 2;
  double sum = 0;
  for (const auto& [x, w] : gauss) sum += w * (f(centre - half * x) + f(centre + half * x));
  return sum / 2;
}

/// Returns the mean of log|u - v| over |v| < 1/2, for a cell of length 1 and a point.
double mean_log_from_point(double u) {
  if (std::abs(u) < 16) {
    const auto near = static_cast<long double>(u);
    return static_cast<double>(once(near + 0.5L) - once(near - 0.5L));
  }
  const double r = 1 / (4 * u * u);
  return std::log(std::abs(u)) - r * (1.0 / 6 + r * (1.0 / 20 + r * (1.0 / 42 + r * (1.0 / 72 + r / 110))));
}

/// From this distance on, in cell lengths, eight points give the mean to the last digits.
constexpr double apart = 2;

}  // namespace

double mean_log(double a, double b, double c, double d) {
  if (b - a > d - c) return mean_log(c, d, a, b);
  const double length = d - c;
  if (a == c) return std::log(length) - 1.5;
  // The rest is the mean of log(distance + u + v) over 0 < u < shorter, 0 < v < length. It contains no places that
  // could be rounded.
  const double shorter = b - a;
  const double distance = std::max({c - b, a - d, 0.0});
  if (distance >= apart * length) {
    return mean(0, shorter,
                [&](double u) { return mean(0, length, [&](double v) { return std::log(distance + u + v); }); });
  }
  const double beyond = distance + length;
  if (distance >= apart * shorter) {
    // Integrate exactly over the longer cell, and by points over the shorter one.
    return mean(0, shorter, [&](double u) { return once(beyond + u) - once(distance + u); }) / length;
  }
  const long double near = (twice(static_cast<long double>(distance) + shorter) - twice(distance)) / shorter;
  if (length >= apart * shorter) {
    // The far end of the longer cell by points, because the exact second difference would be very small for a short
    // cell.
    return static_cast<double>((mean(0, shorter, [&](double u) { return once(beyond + u); }) - near) / length);
  }
  const long double far = (twice(static_cast<long double>(beyond) + shorter) - twice(beyond)) / shorter;
  return static_cast<double>((far - near) / length);
}

double mean_log_of_unit_cells(std::size_t k) {
  const auto x = static_cast<double>(k);
  // For large distances the second difference has no correct digits. Its expansion loses none.
  if (k < 16) {
    const auto u = static_cast<long double>(k);
    return static_cast<double>(twice(u + 1) - 2 * twice(u) + twice(u - 1));
  }
  const double r = 1 / (x * x);
  return std::log(x) - r * (1.0 / 12 + r * (1.0 / 60 + r * (1.0 / 168 + r * (1.0 / 360 + r / 660))));
}

double SurfaceKernel::at(double distance) const { return -std::log(std::abs(distance)) / std::numbers::pi; }

double SurfaceKernel::mean(double a, double b, double c, double d) const {
  return -mean_log(a, b, c, d) / std::numbers::pi;
}

double SurfaceKernel::mean_of_equal_cells(double h, std::size_t cells) const {
  return -h * (std::log(h) + mean_log_of_unit_cells(cells)) / std::numbers::pi;
}

double SurfaceKernel::from_equal_cell(double h, double cells) const {
  return -h * (std::log(h) + mean_log_from_point(cells)) / std::numbers::pi;
}

double SurfaceKernel::mean_from_point(double left, double right, double x) const {
  const double length = right - left;
  const double distance = (left + right) / 2 - x;
  if (std::abs(distance) <= 6 * length) return -((once(right - x) - once(left - x)) / length) / std::numbers::pi;
  const double r = length * length / (distance * distance);
  return -(std::log(std::abs(distance)) - r / 24 - r * r / 320) / std::numbers::pi;
}

double SurfaceKernel::mean_within(double before, double behind, double length) const {
  return -((once(behind) + once(before)) / length) / std::numbers::pi;
}

double SurfaceKernel::slope(double left, double right, double x) const {
  return std::log(std::abs((right - x) / (left - x)));
}

double SurfaceKernel::rise(double left, double right, double from, double to) const {
  const auto once = [](double y) { return y == 0 ? 0 : y * std::log(std::abs(y)) - y; };
  return (once(right - to) - once(left - to)) - (once(right - from) - once(left - from));
}

}  // namespace steadyslide::numeric::variational
