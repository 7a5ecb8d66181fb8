#include "numeric/variational/galerkin_operator.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/variational/logarithmic_kernel.hpp"

namespace steadyslide::numeric::variational {
namespace {

/// The smallest 2^k or 3 * 2^k that is >= n and even.
std::size_t smooth_size(std::size_t n) {
  std::size_t power = 8;
  while (power < n) power *= 2;
  return power / 4 * 3 >= n ? power / 4 * 3 : power;
}

/// The logarithm's entries by i - j.
std::vector<double> toeplitz_entries(const CellMesh& mesh) {
  if (!mesh.is_uniform()) return {};
  const double h = mesh.length(0);
  std::vector<double> entries(mesh.size());
  for (std::size_t k = 0; k < entries.size(); ++k) {
    entries[k] = -h * (std::log(h) + mean_log_of_unit_cells(k)) / std::numbers::pi;
  }
  return entries;
}

}  // namespace

GalerkinOperator::GalerkinOperator(std::vector<double> toeplitz, CellFriction friction)
    : friction_(std::move(friction)), toeplitz_(std::move(toeplitz)) {
  if (toeplitz_.empty()) return;
  const std::size_t n = toeplitz_.size();
  fourier_.emplace(smooth_size(2 * n));
  const std::span<double> values = fourier_->values();
  std::fill(values.begin(), values.end(), 0);
  for (std::size_t k = 0; k < n; ++k) values[k] = values[(values.size() - k) % values.size()] = toeplitz_[k];
  // Between the two branches nothing is asked; joined, the spectrum stays positive.
  for (std::size_t k = n; k + n <= values.size(); ++k) values[k] = toeplitz_[n - 1];
  fourier_->forward();
  for (const std::complex<double>& mode : fourier_->modes()) spectrum_.push_back(mode.real());
}

GalerkinOperator::GalerkinOperator(const CellMesh& mesh, CellFriction friction)
    : GalerkinOperator(toeplitz_entries(mesh), std::move(friction)) {
  if (mesh.is_uniform()) return;
  const std::size_t n = mesh.size();
  logarithm_.resize(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i <= j; ++i) {
      const double mean = -mean_log(mesh.left(i), mesh.right(i), mesh.left(j), mesh.right(j)) / std::numbers::pi;
      logarithm_[i + j * n] = mean * mesh.length(j);
      logarithm_[j + i * n] = mean * mesh.length(i);
    }
  }
}

GalerkinOperator GalerkinOperator::part(std::size_t first, std::size_t count) const {
  const auto slice = [&](const std::vector<double>& all) {
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector<double>(from, from + static_cast<std::ptrdiff_t>(count));
  };
  const auto entries = toeplitz_.begin() + static_cast<std::ptrdiff_t>(count);
  return {std::vector<double>(toeplitz_.begin(), entries),
          CellFriction{slice(friction_.whole), slice(friction_.own), friction_.sign}};
}

double GalerkinOperator::logarithm(std::size_t i, std::size_t j) const {
  return fourier_ ? toeplitz_[i > j ? i - j : j - i] : logarithm_[i + j * size()];
}

double GalerkinOperator::friction_entry(std::size_t i, std::size_t j) const {
  if (i == j) return friction_.own[i];
  const bool felt = friction_.sign > 0 ? j < i : j > i;
  return felt ? friction_.sign * friction_.whole[j] : 0;
}

void GalerkinOperator::multiply_by_transform(std::span<const double> p, std::span<double> result) const {
  const std::span<double> values = fourier_->values();
  std::copy(p.begin(), p.end(), values.begin());
  std::fill(values.begin() + static_cast<std::ptrdiff_t>(p.size()), values.end(), 0);
  fourier_->forward();
  const std::span<std::complex<double>> modes = fourier_->modes();
  const double scale = 1 / static_cast<double>(values.size());
  for (std::size_t k = 0; k < modes.size(); ++k) modes[k] *= spectrum_[k] * scale;
  fourier_->backward();
  std::copy(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(p.size()), result.begin());
}

void GalerkinOperator::multiply(std::span<const double> p, std::span<double> result) const {
  const std::size_t n = size();
  if (fourier_) {
    multiply_by_transform(p, result);
  } else {
    const auto length = static_cast<Eigen::Index>(n);
    const Eigen::Map<const Eigen::MatrixXd> matrix(logarithm_.data(), length, length);
    Eigen::Map<Eigen::VectorXd>(result.data(), length).noalias() =
        matrix * Eigen::Map<const Eigen::VectorXd>(p.data(), length);
  }
  double before = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = friction_.sign > 0 ? k : n - 1 - k;
    result[i] += before + friction_.own[i] * p[i];
    before += friction_.sign * friction_.whole[i] * p[i];
  }
}

}  // namespace steadyslide::numeric::variational
