#include "numeric/variational/galerkin_operator.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>

namespace steadyslide::numeric::variational {
namespace {

/// Returns the kernel's entries by i - j, from 1 - size on: means over cells, and values at their ends.
std::array<std::vector<double>, 2> toeplitz_entries(const CellMesh& mesh, const CellFriction& friction,
                                                    const SurfaceKernel& kernel) {
  if (!mesh.is_uniform()) {
    if (!friction.at_end.empty()) throw std::invalid_argument("the damped friction rule is for equal cells");
    return {};
  }
  const double h = mesh.length(0);
  const std::size_t last = mesh.size() - 1;
  std::vector<double> means(2 * last + 1);
  for (std::size_t k = 0; k <= last; ++k) means[last + k] = means[last - k] = kernel.mean_of_equal_cells(h, k);
  if (friction.at_end.empty()) return {std::move(means), {}};
  std::vector<double> ends(means.size());
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const double between_centres = static_cast<double>(k) - static_cast<double>(last);
    ends[k] = kernel.from_equal_cell(h, between_centres + friction.sign * 0.5);
  }
  return {std::move(means), std::move(ends)};
}

}  // namespace

GalerkinOperator::GalerkinOperator(std::array<std::vector<double>, 2> entries, CellFriction friction,
                                   const SurfaceKernel& kernel)
    : kernel_(kernel), friction_(std::move(friction)) {
  for (std::size_t kind = 0; kind < entries.size(); ++kind) {
    if (entries[kind].empty()) continue;
    convolutions_[kind].entries = std::move(entries[kind]);
    if (!fourier_) fourier_.emplace(fast_length(2 * size()));
    convolutions_[kind].spectrum = spectrum(kind == 1, *fourier_);
  }
}

std::vector<std::complex<double>> GalerkinOperator::spectrum(bool at_end, const Fourier& circle) const {
  const std::vector<double>& entries = convolutions_[at_end ? 1 : 0].entries;
  const std::span<double> values = circle.values();
  const auto n = static_cast<std::ptrdiff_t>(values.size());
  const auto last = static_cast<std::ptrdiff_t>(size() - 1);
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    // Distances larger than all cells do not occur. The last entry is used there, so that the spectrum stays positive.
    const std::ptrdiff_t distance = std::clamp(2 * k <= n ? k : k - n, -last, last);
    values[static_cast<std::size_t>(k)] = entries[static_cast<std::size_t>(last + distance)];
  }
  circle.forward();
  return {circle.modes().begin(), circle.modes().end()};
}

GalerkinOperator::GalerkinOperator(const CellMesh& mesh, CellFriction friction, const SurfaceKernel& kernel)
    : GalerkinOperator(toeplitz_entries(mesh, friction, kernel), friction, kernel) {
  if (mesh.is_uniform()) return;
  const std::size_t n = mesh.size();
  logarithm_.resize(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i <= j; ++i) {
      const double mean = kernel.mean(mesh.left(i), mesh.right(i), mesh.left(j), mesh.right(j));
      logarithm_[i + j * n] = mean * mesh.length(j);
      logarithm_[j + i * n] = mean * mesh.length(i);
    }
  }
}

GalerkinOperator GalerkinOperator::part(std::size_t first, std::size_t count) const {
  const auto slice = [](const auto& all, std::size_t from, std::size_t length) {
    if (all.empty()) return all;
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(from);
    return std::decay_t<decltype(all)>(begin, begin + static_cast<std::ptrdiff_t>(length));
  };
  const auto entries = [&](std::size_t kind) {
    return slice(convolutions_[kind].entries, size() - count, 2 * count - 1);
  };
  return {{entries(0), entries(1)},
          {slice(friction_.whole, first, count), slice(friction_.own, first, count), friction_.sign,
           slice(friction_.at_end, first, count)},
          kernel_};
}

double GalerkinOperator::logarithm(std::size_t i, std::size_t j) const {
  if (!fourier_) return logarithm_[i + j * size()];
  return convolutions_[friction_.is_at_end(i) ? 1 : 0].entries[size() - 1 + i - j];
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
  fourier_->convolve(convolutions_[0].spectrum, result);
  if (friction_.at_end.empty()) return;
  std::vector<double> at_end(p.size());
  fourier_->convolve(convolutions_[1].spectrum, at_end);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (friction_.is_at_end(i)) result[i] = at_end[i];
  }
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
