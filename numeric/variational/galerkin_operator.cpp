#include "numeric/variational/galerkin_operator.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace steadyslide::numeric::variational {
namespace {

/// Returns the entries by i - j, from 1 - size on. entry(distance) is that for i - j cells.
template <class Entry>
std::vector<double> toeplitz(std::size_t size, const Entry& entry) {
  std::vector<double> entries(2 * size - 1);
  for (std::size_t k = 0; k < entries.size(); ++k)
    entries[k] = entry(static_cast<double>(k) - static_cast<double>(size - 1));
  return entries;
}

}  // namespace

GalerkinOperator::Kinds GalerkinOperator::kernels_on(const CellMesh& mesh, const CellFriction& friction,
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
  return {std::move(means),
          toeplitz(mesh.size(), [&](double cells) { return kernel.from_equal_cell(h, cells + friction.sign * 0.5); })};
}

GalerkinOperator::Kinds GalerkinOperator::couplings_on(const CellMesh& mesh, const CellFriction& friction,
                                                       const SurfaceKernel& kernel) {
  if (kernel.is_half_plane()) return {};
  const double h = mesh.length(0);
  Kinds result{toeplitz(mesh.size(), [&](double cells) { return kernel.coupling_of_equal_cells(h, cells); }), {}};
  if (friction.at_end.empty()) return result;
  result[1] = toeplitz(mesh.size(),
                       [&](double cells) { return kernel.coupling_from_equal_cell(h, cells + friction.sign * 0.5); });
  return result;
}

GalerkinOperator::GalerkinOperator(Kinds kernels, Kinds couplings, CellFriction friction, const SurfaceKernel& kernel)
    : kernel_(kernel), friction_(std::move(friction)) {
  const auto set = [this](Kinds& entries, std::array<Convolution, 2>& kinds) {
    for (std::size_t kind = 0; kind < entries.size(); ++kind) {
      if (entries[kind].empty()) continue;
      kinds[kind].entries = std::move(entries[kind]);
      if (!fourier_) fourier_.emplace(fast_length(2 * size()));
      kinds[kind].spectrum = circulant(kinds[kind].entries, *fourier_);
    }
  };
  set(kernels, kernels_);
  set(couplings, couplings_);
}

std::vector<std::complex<double>> GalerkinOperator::circulant(const std::vector<double>& entries,
                                                              const Fourier& circle) const {
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

std::vector<std::complex<double>> GalerkinOperator::spectrum(bool at_end, double length, const Fourier& circle) const {
  if (kernel_.is_half_plane()) return circulant(kernels_[at_end ? 1 : 0].entries, circle);
  const SurfaceKernel half_plane;
  std::vector<std::complex<double>> result =
      circulant(toeplitz(size(),
                         [&](double cells) {
                           if (at_end) return half_plane.from_equal_cell(length, cells + friction_.sign * 0.5);
                           return half_plane.mean_of_equal_cells(length, static_cast<std::size_t>(std::abs(cells)));
                         }),
                circle);
  const double lowest = 2 * std::numbers::pi / (length * static_cast<double>(circle.size()));
  for (std::size_t k = 1; k < result.size(); ++k) result[k] *= kernel_.symbols(lowest * static_cast<double>(k)).first;
  return result;
}

GalerkinOperator::GalerkinOperator(const CellMesh& mesh, const CellFriction& friction, const SurfaceKernel& kernel)
    : GalerkinOperator(kernels_on(mesh, friction, kernel), couplings_on(mesh, friction, kernel), friction, kernel) {
  if (mesh.is_uniform()) return;
  const std::size_t n = mesh.size();
  matrix_.resize(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i <= j; ++i) {
      const double mean = kernel.mean(mesh.left(i), mesh.right(i), mesh.left(j), mesh.right(j));
      matrix_[i + j * n] = mean * mesh.length(j);
      matrix_[j + i * n] = mean * mesh.length(i);
    }
  }
}

GalerkinOperator GalerkinOperator::part(std::size_t first, std::size_t count) const {
  const auto slice = [](const auto& all, std::size_t from, std::size_t length) {
    if (all.empty()) return all;
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(from);
    return std::decay_t<decltype(all)>(begin, begin + static_cast<std::ptrdiff_t>(length));
  };
  const auto entries = [&](const std::array<Convolution, 2>& kinds) {
    const auto of = [&](std::size_t kind) { return slice(kinds[kind].entries, size() - count, 2 * count - 1); };
    return Kinds{of(0), of(1)};
  };
  GalerkinOperator result(
      {entries(kernels_),
       entries(couplings_),
       {slice(friction_.whole, first, count), slice(friction_.own, first, count), friction_.sign,
        slice(friction_.at_end, first, count), friction_.shift, slice(friction_.signed_friction, first, count)},
       kernel_});
  result.diagonal_ = slice(diagonal_, first, count);
  return result;
}

void GalerkinOperator::add_diagonal(const std::vector<double>& diagonal) {
  diagonal_.resize(size());
  for (std::size_t i = 0; i < size(); ++i) diagonal_[i] += diagonal[i];
}

double GalerkinOperator::kernel_entry(std::size_t i, std::size_t j) const {
  if (!fourier_) return matrix_[i + j * size()];
  return kernels_[friction_.is_at_end(i) ? 1 : 0].entries[size() - 1 + i - j];
}

double GalerkinOperator::friction_entry(std::size_t i, std::size_t j) const {
  const std::vector<double>& couplings = couplings_[friction_.is_at_end(i) ? 1 : 0].entries;
  const double coupled = couplings.empty() ? 0 : couplings[size() - 1 + i - j] * friction_.signed_friction[j];
  if (i == j) return coupled + friction_.own[i];
  const bool felt = friction_.sign > 0 ? j < i : j > i;
  return coupled + (felt ? friction_.sign * friction_.whole[j] : 0);
}

void GalerkinOperator::convolve(const std::array<Convolution, 2>& kinds, std::span<const double> p, bool weighted,
                                std::span<double> result) const {
  const std::span<double> values = fourier_->values();
  std::copy(p.begin(), p.end(), values.begin());
  std::fill(values.begin() + static_cast<std::ptrdiff_t>(p.size()), values.end(), 0);
  for (std::size_t i = 0; weighted && i < p.size(); ++i) values[i] *= friction_.signed_friction[i];
  fourier_->forward();
  fourier_->convolve(kinds[0].spectrum, result);
  if (friction_.at_end.empty()) return;
  std::vector<double> at_end(p.size());
  fourier_->convolve(kinds[1].spectrum, at_end);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (friction_.is_at_end(i)) result[i] = at_end[i];
  }
}

void GalerkinOperator::multiply(std::span<const double> p, std::span<double> result) const {
  const std::size_t n = size();
  if (fourier_) {
    convolve(kernels_, p, false, result);
    if (!couplings_[0].entries.empty()) {
      std::vector<double> coupled(n);
      convolve(couplings_, p, true, coupled);
      for (std::size_t i = 0; i < n; ++i) result[i] += coupled[i];
    }
  } else {
    const auto length = static_cast<Eigen::Index>(n);
    const Eigen::Map<const Eigen::MatrixXd> matrix(matrix_.data(), length, length);
    Eigen::Map<Eigen::VectorXd>(result.data(), length).noalias() =
        matrix * Eigen::Map<const Eigen::VectorXd>(p.data(), length);
  }
  double before = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = friction_.sign > 0 ? k : n - 1 - k;
    result[i] += before + (friction_.own[i] + diagonal(i)) * p[i];
    before += friction_.sign * friction_.whole[i] * p[i];
  }
}

}  // namespace steadyslide::numeric::variational
