#include "numeric/variational/surface_kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
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
double gauss_mean(double a, double b, const F& f) {
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
    return gauss_mean(0, shorter, [&](double u) {
      return gauss_mean(0, length, [&](double v) { return std::log(distance + u + v); });
    });
  }
  const double beyond = distance + length;
  if (distance >= apart * shorter) {
    // Integrate exactly over the longer cell, and by points over the shorter one.
    return gauss_mean(0, shorter, [&](double u) { return once(beyond + u) - once(distance + u); }) / length;
  }
  const long double near = (twice(static_cast<long double>(distance) + shorter) - twice(distance)) / shorter;
  if (length >= apart * shorter) {
    // The far end of the longer cell by points, because the exact second difference would be very small for a short
    // cell.
    return static_cast<double>((gauss_mean(0, shorter, [&](double u) { return once(beyond + u); }) - near) / length);
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

SurfaceKernel::SurfaceKernel(std::shared_ptr<const SurfaceCorrection<double>> body, double unit, double friction)
    : body_(std::move(body)), unit_(unit) {
  if (!body_) return;
  if (const std::optional<double> period = body_->period()) period_ = *period / unit_;
  constexpr int places = 1000;
  double least = 0;
  for (int i = 0; i <= places; ++i) {
    const double y = static_cast<double>(i) / places;
    const double near = folded(y);
    const double logarithm = std::log(std::max(near, 0.5 / places));
    least = std::min(least, normal(near) - logarithm - friction * std::abs(turning(y)));
  }
  constant_ = -2 * least;
}

double SurfaceKernel::parts_of(double h, double from, double to) const {
  // Eight points on parts of half the distance of a singularity are exact to the last digits.
  const double near = from < 0 && to > 0 ? 0 : std::min(std::abs(from), std::abs(to));
  const double far = std::max(std::abs(from), std::abs(to));
  return std::ceil(2 * h * unit_ / std::min(body_->radius(unit_ * near), body_->radius(unit_ * far)));
}

template <class F>
double SurfaceKernel::smooth_mean(double y, double h, const F& f) const {
  const double parts = parts_of(h, y - h / 2, y + h / 2);
  double sum = 0;
  for (double part = 0; part < parts; ++part)
    sum += gauss_mean(y - h / 2 + h * part / parts, y - h / 2 + h * (part + 1) / parts, f);
  return sum / parts;
}

template <class F>
double SurfaceKernel::smooth_mean_of_cells(double y, double h, const F& f) const {
  const double parts = parts_of(h, y - h, y + h);
  double sum = 0;
  for (const double side : {-1.0, 1.0}) {
    const auto weighted = [&](double v) { return (1 - v) * f(y + side * h * v); };
    for (double part = 0; part < parts; ++part) sum += gauss_mean(part / parts, (part + 1) / parts, weighted);
  }
  return sum / parts;
}

double SurfaceKernel::at(double distance) const {
  const double near = folded(distance);
  return ((body_ ? normal(near) + constant_ : 0) - std::log(near)) / std::numbers::pi;
}

double SurfaceKernel::mean(double a, double b, double c, double d) const {
  if (body_) throw std::logic_error("cells of different lengths are for the half-plane");
  return -mean_log(a, b, c, d) / std::numbers::pi;
}

double SurfaceKernel::mean_of_equal_cells(double h, std::size_t cells) const {
  const double y = h * static_cast<double>(cells);
  const double near = folded(y);
  const double logarithm = near == y ? std::log(h) + mean_log_of_unit_cells(cells)
                                     : mean_log(0, h, std::max(near, h), std::max(near, h) + h);
  if (!body_) return -h * logarithm / std::numbers::pi;
  const double smooth = smooth_mean_of_cells(near, h, [this](double at) { return normal(at); });
  return h * (smooth + constant_ - logarithm) / std::numbers::pi;
}

double SurfaceKernel::from_equal_cell(double h, double cells) const {
  const double near = folded(h * cells);
  const double logarithm = std::log(h) + mean_log_from_point(body_ ? near / h : cells);
  if (!body_) return -h * logarithm / std::numbers::pi;
  const double smooth = smooth_mean(near, h, [this](double at) { return normal(at); });
  return h * (smooth + constant_ - logarithm) / std::numbers::pi;
}

double SurfaceKernel::mean_from_point(double left, double right, double x) const {
  const double length = right - left;
  if (body_) return from_equal_cell(length, ((left + right) / 2 - x) / length) / length;
  const double distance = (left + right) / 2 - x;
  if (std::abs(distance) <= 6 * length) return -((once(right - x) - once(left - x)) / length) / std::numbers::pi;
  const double r = length * length / (distance * distance);
  return -(std::log(std::abs(distance)) - r / 24 - r * r / 320) / std::numbers::pi;
}

double SurfaceKernel::mean_within(double before, double behind, double length) const {
  if (body_) throw std::logic_error("a point inside a cell is for the half-plane");
  return -((once(behind) + once(before)) / length) / std::numbers::pi;
}

double SurfaceKernel::coupling(double distance) const { return body_ ? -turning(distance) / std::numbers::pi : 0; }

double SurfaceKernel::coupling_of_equal_cells(double h, double cells) const {
  if (!body_) return 0;
  if (std::isfinite(period_)) return h * coupling(h * cells);  // T is linear
  return -h * smooth_mean_of_cells(h * cells, h, [this](double y) { return turning(y); }) / std::numbers::pi;
}

double SurfaceKernel::coupling_from_equal_cell(double h, double cells) const {
  if (!body_) return 0;
  if (std::isfinite(period_)) return h * coupling(h * cells);
  return -h * smooth_mean(h * cells, h, [this](double y) { return turning(y); }) / std::numbers::pi;
}

double SurfaceKernel::slope(double left, double right, double x, double f) const {
  if (!body_) return std::log(std::abs((right - x) / (left - x)));
  // u'/c is the half-plane's slope minus w, and the integral of N' + f T' over the cell is exact.
  const double to = folded(right - x), from = folded(left - x);
  return std::log(to / from) - normal(to) + normal(from) - f * (turning(right - x) - turning(left - x));
}

double SurfaceKernel::rise(double left, double right, double from, double to, double f) const {
  const auto effect = [&](double x) {
    if (!body_) return once(left - x) - once(right - x);
    const double length = right - left, centre = (left + right) / 2;
    return std::numbers::pi *
           (length * mean_from_point(left, right, x) + f * coupling_from_equal_cell(length, (x - centre) / length));
  };
  return effect(from) - effect(to);
}

}  // namespace steadyslide::numeric::variational
