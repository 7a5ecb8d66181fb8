#pragma once
// Galerkin's operator on piecewise constant pressures p = -t >= 0, in xi:
//
//   (B p)_i = mean over cell i of  -(1/pi) int p(xi') log|xi - xi'| dxi' + int_left^xi s p,
//
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
  GalerkinOperator(const CellMesh& mesh, CellFriction friction, const SurfaceKernel& kernel = {});
  /// Returns the operator for pressures on neighbouring cells, with the displacement on the same cells, up to a
  /// constant. The mesh must be uniform.
  GalerkinOperator part(std::size_t first, std::size_t count) const;

  std::size_t size() const { return friction_.whole.size(); }
  double entry(std::size_t i, std::size_t j) const { return logarithm(i, j) + friction_entry(i, j); }
  /// Return the two parts of an entry: that of the kernel and that of the friction.
  double logarithm(std::size_t i, std::size_t j) const;
  double friction_entry(std::size_t i, std::size_t j) const;
  /// Computes B p, on a uniform mesh by two transforms (three if some equations apply at ends of cells), otherwise by
  /// the whole matrix. Not thread-safe.
  void multiply(std::span<const double> p, std::span<double> result) const;

  const CellFriction& friction() const { return friction_; }
  const SurfaceKernel& kernel() const { return kernel_; }
  /// Returns the length of the transforms; 0 if the mesh is not uniform.
  std::size_t transform_size() const { return fourier_ ? fourier_->size() : 0; }
  /// Returns the eigenvalues of the kernel's circulant on a circle of cells with the length of the transform, on a
  /// uniform mesh: for means over cells, or for values at the cells' ends.
  std::vector<std::complex<double>> spectrum(bool at_end, const Fourier& circle) const;

 private:
  /// The kernel on equal cells: entries by i - j, from 1 - size() on, and the spectrum.
  struct Convolution {
    std::vector<double> entries;
    std::vector<std::complex<double>> spectrum;
  };
  /// Takes the entries for equal cells; empty for other meshes.
  GalerkinOperator(std::array<std::vector<double>, 2> entries, CellFriction friction, const SurfaceKernel& kernel);
  void multiply_by_transform(std::span<const double> p, std::span<double> result) const;

  SurfaceKernel kernel_;
  CellFriction friction_;
  // For a uniform mesh: means over cells, and values at their ends.
  std::array<Convolution, 2> convolutions_;
  std::optional<Fourier> fourier_;
  // For other meshes: all entries of the kernel, column by column.
  std::vector<double> logarithm_;
};

}  // namespace steadyslide::numeric::variational
