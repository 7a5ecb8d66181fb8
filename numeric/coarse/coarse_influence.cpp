#include "numeric/coarse/coarse_influence.hpp"

#include <cmath>
#include <numbers>

namespace steadyslide::numeric::coarse {

namespace {

/// int log|y| dy.
double log_integral(double y) { return y == 0 ? 0 : y * (std::log(std::abs(y)) - 1); }

}  // namespace

Influence::Influence(const Mesh& mesh) : mesh_(mesh), columns_(mesh.size()) {
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    points_.push_back(mesh.point(i));
    profile_.push_back(mesh.piece(i).profile_at(points_[i]));
  }
}

const double* Influence::column(std::size_t j) {
  if (columns_[j].empty()) {
    columns_[j].resize(size());
    compute(j, columns_[j].data());
  }
  return columns_[j].data();
}

void Influence::compute(std::size_t j, double* column) const {
  const double length = mesh_.length(j);
  const double centre = mesh_.centre(j);
  const SupportPiece& piece = mesh_.piece(j);
  for (std::size_t i = 0; i < size(); ++i) {
    const double distance = centre - points_[i];
    double mean;
    if (i == j) {
      mean = (log_integral(piece.behind * length) + log_integral(piece.ahead * length)) / length;
    } else if (std::abs(distance) > 6 * length) {
      const double r = length * length / (distance * distance);
      mean = std::log(std::abs(distance)) - r / 24 - r * r / 320;
    } else {
      mean = (log_integral(mesh_.right(j) - points_[i]) - log_integral(mesh_.left(j) - points_[i])) / length;
    }
    column[i] = -mean / std::numbers::pi + (j < i ? piece.s : j == i ? piece.s * piece.ahead : 0);
  }
}

}  // namespace steadyslide::numeric::coarse
