#pragma once
// Galerkin's operator on piecewise constant pressures p = -t >= 0, in xi:
//
//   (B p)_i = mean over cell i of  -(1/pi) int p(xi') log|xi - xi'| dxi' + int_left^xi s p,
//
// how far p pushes the surface down, -u/c. Where s is negative the second integral is -int_xi^right s p: a constant
// less, which the indenter's approach takes up. So no entry of B is negative. [Bal16, section 3.1]

#include <optional>
#include <span>
#include <vector>

#include "numeric/variational/cell_data.hpp"
#include "numeric/variational/fourier.hpp"

namespace steadyslide::numeric::variational {

class GalerkinOperator {
 public:
  GalerkinOperator(const CellMesh& mesh, CellFriction friction);
  /// The same for pressures on neighbouring cells alone, looked at on these, up to a constant; on a uniform mesh only.
  GalerkinOperator part(std::size_t first, std::size_t count) const;

  std::size_t size() const { return friction_.whole.size(); }
  double entry(std::size_t i, std::size_t j) const { return logarithm(i, j) + friction_entry(i, j); }
  /// The two parts of an entry.
  double logarithm(std::size_t i, std::size_t j) const;
  double friction_entry(std::size_t i, std::size_t j) const;
  /// B p, by two transforms on a uniform mesh, by the whole matrix on any other. Not to be called from two threads.
  void multiply(std::span<const double> p, std::span<double> result) const;

  const CellFriction& friction() const { return friction_; }
  /// Of the transforms; 0 on a mesh that is not uniform.
  std::size_t transform_size() const { return fourier_ ? fourier_->size() : 0; }
  /// The eigenvalues of the logarithm's circulant over transform_size() cells, transform_size()/2 + 1 of them.
  const std::vector<double>& spectrum() const { return spectrum_; }

 private:
  /// On equal cells.
  GalerkinOperator(std::vector<double> toeplitz, CellFriction friction);
  void multiply_by_transform(std::span<const double> p, std::span<double> result) const;

  CellFriction friction_;
  // Uniform mesh: the logarithm's entries by i - j; else all of them, column by column.
  std::vector<double> toeplitz_;
  std::vector<double> spectrum_;
  std::optional<Fourier> fourier_;
  std::vector<double> logarithm_;
};

}  // namespace steadyslide::numeric::variational
