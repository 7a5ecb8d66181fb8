#pragma once
// Galerkin's operator on piecewise constant pressures p = -t >= 0, in xi:
//
//   (B p)_i = mean over cell i of  -(1/pi) int p(xi') log|xi - xi'| dxi' + int_left^xi s p,
//
// how far p pushes the surface down, -u/c. Where s is negative the second integral is -int_xi^right s p: a constant
// less, which the indenter's approach takes up. So no entry of B is negative. [Bal16, section 3.1]
//
// Under the damped rule (friction_rule.hpp) the same at the end of cell i where s is strong.

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
  /// Cells that are asked at their ends: on a uniform mesh only.
  GalerkinOperator(const CellMesh& mesh, CellFriction friction, const SurfaceKernel& kernel = {});
  /// The same for pressures on neighbouring cells alone, looked at on these, up to a constant; on a uniform mesh only.
  GalerkinOperator part(std::size_t first, std::size_t count) const;

  std::size_t size() const { return friction_.whole.size(); }
  double entry(std::size_t i, std::size_t j) const { return logarithm(i, j) + friction_entry(i, j); }
  /// The two parts of an entry: the kernel's and the friction's.
  double logarithm(std::size_t i, std::size_t j) const;
  double friction_entry(std::size_t i, std::size_t j) const;
  /// B p, by two transforms on a uniform mesh (three where some cells are asked at their ends), by the whole matrix on any other. Not to be called from two threads.
  void multiply(std::span<const double> p, std::span<double> result) const;

  const CellFriction& friction() const { return friction_; }
  const SurfaceKernel& kernel() const { return kernel_; }
  /// Of the transforms; 0 on a mesh that is not uniform.
  std::size_t transform_size() const { return fourier_ ? fourier_->size() : 0; }
  /// The eigenvalues of the kernel's circulant over the cells of a circle as long as the transform, on a uniform mesh: of
  /// the means, or at the cells' ends if some ask for it.
  std::vector<std::complex<double>> spectrum(bool at_end, const Fourier& circle) const;

 private:
  /// The kernel on equal cells: entries by i - j from 1 - size() on, and the spectrum.
  struct Convolution {
    std::vector<double> entries;
    std::vector<std::complex<double>> spectrum;
  };
  /// On equal cells; without entries: on others.
  GalerkinOperator(std::array<std::vector<double>, 2> entries, CellFriction friction, const SurfaceKernel& kernel);
  void multiply_by_transform(std::span<const double> p, std::span<double> result) const;

  SurfaceKernel kernel_;
  CellFriction friction_;
  // Uniform mesh: for means over cells, and at their ends.
  std::array<Convolution, 2> convolutions_;
  std::optional<Fourier> fourier_;
  // Any other: all entries of the kernel, column by column.
  std::vector<double> logarithm_;
};

}  // namespace steadyslide::numeric::variational
