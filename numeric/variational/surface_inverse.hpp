#pragma once
// An approximate inverse of the operator B on cells of a uniform mesh, by Fourier transforms: on a whole line under one
// friction value B is a convolution and its symbol's reciprocal is exact; here each cell takes that of its own s.

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
  /// Cells under about the same s, and 1/symbol for it.
  struct Zone {
    std::vector<std::complex<double>> reciprocal;
  };
  std::vector<unsigned char> zone_of_;
  std::vector<Zone> zones_;
  Fourier fourier_;
  std::vector<std::complex<double>> modes_;
};

}  // namespace steadyslide::numeric::variational
