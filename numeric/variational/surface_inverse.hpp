#pragma once
// An approximate inverse of the operator B on cells of a uniform mesh, by Fourier transforms: on a whole line under one
// friction value B is a convolution and its symbol's reciprocal is exact; here each cell takes that of its own s. The
// inverse's kernel falls as the square of the distance, so that the line may close soon behind the cells.

#include <span>
#include <vector>

#include "numeric/variational/galerkin_operator.hpp"

namespace steadyslide::numeric::variational {

class SurfaceInverse {
 public:
  /// `length`: of a cell.
  SurfaceInverse(const GalerkinOperator& influence, double length);
  /// The pressure that pushes the surface down by about r (both over all cells).
  void apply(std::span<const double> r, std::span<double> p);

 private:
  std::vector<unsigned char> zone_of_;                          ///< cells under about the same s
  std::vector<std::vector<std::complex<double>>> reciprocals_;  ///< 1/symbol for the s of each zone
  Fourier fourier_;
  std::vector<std::complex<double>> modes_;
};

}  // namespace steadyslide::numeric::variational
