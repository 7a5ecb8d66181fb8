#pragma once
// An approximate inverse of the operator B on cells of a uniform mesh, by Fourier transforms: on a whole line under one
// friction value B is a convolution and its symbol's reciprocal is exact; here each cell takes that of its own s. The
// inverse's kernel falls as the square of the distance, so that the line may close soon behind the cells, and that zones
// apart are inverted each by itself, by transforms no longer than the zone.

#include <map>
#include <span>
#include <vector>

#include "numeric/variational/galerkin_operator.hpp"

namespace steadyslide::numeric::variational {

/// Neighbouring cells.
struct CellRange {
  std::size_t first;
  std::size_t count;
};

class SurfaceInverse {
 public:
  /// `length`: of a cell. The operator has to be there as long as this.
  SurfaceInverse(const GalerkinOperator& influence, double length);
  /// From now on for pressures on these cells.
  void restrict_to(std::vector<CellRange> zones);
  /// The pressure that pushes the surface down by about r (both over all cells), in each zone by the r in it; up to a
  /// constant r in each zone, which is what the others there and the zone's own load make.
  void apply(std::span<const double> r, std::span<double> p);

 private:
  /// Transforms of one length.
  struct Circle {
    Fourier fourier;
    std::map<unsigned char, std::vector<std::complex<double>>> reciprocals;  ///< 1/symbol by the kind of cells

    explicit Circle(std::size_t length) : fourier(length) {}
  };
  struct Zone {
    CellRange cells;
    Circle* circle;
    std::vector<unsigned char> kinds;  ///< of its cells
  };
  std::vector<std::complex<double>> reciprocal(double s, const Fourier& fourier) const;

  const GalerkinOperator& influence_;
  double length_;
  std::vector<double> values_;          ///< of s, one a kind
  std::vector<unsigned char> kind_of_;  ///< of each cell: those under about the same s
  std::map<std::size_t, Circle> circles_;
  std::vector<Zone> zones_;
  std::vector<double> pressures_;  ///< room
};

}  // namespace steadyslide::numeric::variational
