#include "numeric/bodies/correction_sum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/solution/gathered_forces.hpp"

namespace steadyslide::numeric {

CorrectionSum::CorrectionSum(std::shared_ptr<const SurfaceCorrection<double>> correction,
                             const PiecewiseTraction<double>& traction)
    : correction_(std::move(correction)), forces_(gathered_forces(traction, correction_->radius(0))) {
  for (std::size_t part = 0; part < forces_.parts(); ++part) {
    for (std::size_t j = 0; j < SurfaceForces::order; ++j)
      places_.push_back(forces_.middle(part) + forces_.from_middle(j));
  }
}

double CorrectionSum::slope(double x) const {
  double sum = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double y = places_[i] - x;
    sum += forces_.normal[i] * correction_->normal_slope(y);
    if (forces_.tangential[i] != 0) sum -= forces_.tangential[i] * correction_->coupling_slope(y);
  }
  return sum / std::numbers::pi;
}

double CorrectionSum::height(double x) const {
  double sum = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double y = places_[i] - x;
    sum += forces_.tangential[i] * correction_->coupling(y) - forces_.normal[i] * correction_->normal(y);
  }
  return sum / std::numbers::pi;
}

Estimate<double> CorrectionSum::absolute_on_the_right(double x, double gamma) const {
  double sum = 0, size = 0, largest = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double distance = x - places_[i], logarithm = std::log(distance);
    const double kernel = std::abs(logarithm) + std::abs(correction_->normal(distance));
    sum -= forces_.normal[i] * logarithm + std::numbers::pi / 2 * gamma * forces_.tangential[i];
    size += kernel * std::abs(forces_.normal[i]) + 4 * std::abs(forces_.tangential[i]);
    largest = std::max(largest, kernel);
  }
  const double error = 16 * epsilon<double>() * size + largest * forces_.normal_error + 4 * forces_.tangential_error;
  return {sum / std::numbers::pi - height(x), error / std::numbers::pi};
}

}  // namespace steadyslide::numeric
