#pragma once
// Galerkin's operator on piecewise constant pressures p = -t >= 0, in xi:
//
//   (B p)_i = mean over cell i of  int k(xi - xi') p(xi') dxi' + int_left^xi s p + int j(xi - xi') f p dxi',
//
// with k = -log|.|/pi and j = 0 on the half-plane (surface_kernel.hpp),
// the displacement of the surface downwards by p, -u/c. If s is negative, the second integral is -int_xi^right s p. It
// differs by a constant, which is part of the indenter's approach. So no entry of B is negative. [Bal16, section 3.1]
//
// With the damped rule (friction_rule.hpp) and strong s, the same at the end of cell i.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "numeric/variational/cell_data.hpp"
#include "numeric/variational/fourier.hpp"
#include "numeric/variational/surface_kernel.hpp"

namespace steadyslide::numeric::variational {

class GalerkinOperator {
 public:
  /// Equations at ends of cells require a uniform mesh.
  GalerkinOperator(const CellMesh& mesh, const CellFriction& friction, const SurfaceKernel& kernel = {});
  /// Returns the operator for pressures on neighbouring cells, with the displacement on the same cells, up to a
  /// constant. The mesh must be uniform.
  GalerkinOperator part(std::size_t first, std::size_t count) const;
  /// Adds diagonal[i] p_i to the displacement of each cell, diagonal[i] >= 0.
  void add_diagonal(const std::vector<double>& diagonal);

  std::size_t size() const { return friction_.whole.size(); }
  double entry(std::size_t i, std::size_t j) const {
    return kernel_entry(i, j) + friction_entry(i, j) + (i == j ? diagonal(i) : 0);
  }
  /// Return the three parts of an entry: that of k, that of the friction, and what was added.
  double kernel_entry(std::size_t i, std::size_t j) const;
  double friction_entry(std::size_t i, std::size_t j) const;
  double diagonal(std::size_t i) const { return diagonal_.empty() ? 0 : diagonal_[i]; }
  /// Computes B p, on a uniform mesh by two transforms (three if some equations apply at ends of cells, twice as many if
  /// j is not 0), otherwise by the whole matrix. Not thread-safe.
  void multiply(std::span<const double> p, std::span<double> result) const;

  const CellFriction& friction() const { return friction_; }
  const SurfaceKernel& kernel() const { return kernel_; }
  /// Returns the length of the transforms; 0 if the mesh is not uniform.
  std::size_t transform_size() const { return fourier_ ? fourier_->size() : 0; }
  /// Returns approximate eigenvalues of k's circulant on a circle of cells with the length of the transform, on a uniform
  /// mesh with cells of this length: for means over cells, or for values at the cells' ends. They are those of the
  /// half-plane times W, which is positive.
  std::vector<std::complex<double>> spectrum(bool at_end, double length, const Fourier& circle) const;

 private:
  /// A kernel on equal cells: entries by i - j, from 1 - size() on, and the spectrum.
  struct Convolution {
    std::vector<double> entries;
    std::vector<std::complex<double>> spectrum;
  };
  /// Means over cells, and values at their ends. Empty: the kernel is 0, or no equation is of this kind.
  using Kinds = std::array<std::vector<double>, 2>;
  /// Takes the entries of k and j for equal cells; empty for other meshes.
  GalerkinOperator(Kinds kernels, Kinds couplings, CellFriction friction, const SurfaceKernel& kernel);
  static Kinds kernels_on(const CellMesh& mesh, const CellFriction& friction, const SurfaceKernel& kernel);
  static Kinds couplings_on(const CellMesh& mesh, const CellFriction& friction, const SurfaceKernel& kernel);
  std::vector<std::complex<double>> circulant(const std::vector<double>& entries, const Fourier& circle) const;
  /// Computes the convolution with p; with f p if `weighted`.
  void convolve(const std::array<Convolution, 2>& kinds, std::span<const double> p, bool weighted,
                std::span<double> result) const;

  SurfaceKernel kernel_;
  CellFriction friction_;
  std::vector<double> diagonal_;  ///< empty: nothing was added
  // For a uniform mesh: means over cells, and values at their ends.
  std::array<Convolution, 2> kernels_, couplings_;
  std::optional<Fourier> fourier_;
  // For other meshes: all entries of k, column by column.
  std::vector<double> matrix_;
};

}  // namespace steadyslide::numeric::variational
