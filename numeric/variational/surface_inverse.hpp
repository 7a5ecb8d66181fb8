#pragma once
// An approximate inverse of the operator B on cells of a uniform mesh, by Fourier transforms: on a whole line under one
// friction value B is a convolution and its symbol's reciprocal is exact; here each cell takes that of its own s. The
// inverse's kernel falls as the square of the distance, so that the line may close soon behind the cells, and that zones
// apart are inverted each by itself, by transforms no longer than the zone.

#include <Eigen/Core>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "numeric/number/dense_lu.hpp"
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

/// What zones of contact do to each other, for an approximate inverse M^-1 that takes each of them by itself. From outside a
/// zone is seen at a few points of it alone, Chebyshev's: S p are the loads there, T y is interpolated between values there, and
///
///   B = M + T K S, nearly,   (M + T K S)^-1 = M^-1 - Phi (1 + K S Phi)^-1 K S M^-1,   Phi = M^-1 T,
///
/// where K is the kernel between points of different zones. Its blocks for a zone alone are what B does and M leaves out: M
/// knows no constant. Without it each zone costs about one more step of Krylov's method.
class ZoneCoupling {
 public:
  using Vector = Eigen::VectorXd;
  using Map = std::function<Vector(const Vector&)>;
  /// Points of a zone: as many products are taken.
  static constexpr Eigen::Index points = 3;

  /// Vectors are over `cells`, increasing, each in one of the zones, which are increasing too; h: length of a cell. Where the
  /// zones of `last` are nearly these, its K is taken.
  ZoneCoupling(const GalerkinOperator& influence, double h, std::span<const std::size_t> cells,
               std::span<const CellRange> zones, const Map& product, const Map& inverse, const ZoneCoupling* last);
  /// From M^-1 r to (M + T K S)^-1 r.
  void correct(Vector& p) const;

 private:
  using Matrix = Eigen::MatrixXd;
  using Block = Eigen::Matrix<double, points, points>;
  struct Zone {
    CellRange cells;
    double centre;
    double half;             ///< half of its length
    Eigen::Index first = 0;  ///< in vectors
    Eigen::Index count = 0;
    Block moments = Block::Zero();  ///< S Phi
    double friction = 0;            ///< s under its pressures
  };
  static Eigen::Index row(std::size_t zone) { return points * static_cast<Eigen::Index>(zone); }
  bool fits(const ZoneCoupling& other) const;
  /// K between points of different zones.
  Block kernel(const Zone& at, const Zone& from) const;
  void make_kernel(const Map& product);

  SurfaceKernel surface_;
  double h_;
  double sign_;
  std::vector<Zone> zones_;
  Matrix interpolation_;  ///< T, the columns of all zones in one another's place
  Matrix responses_;      ///< Phi, likewise
  Matrix k_;
  DenseLu lu_;  ///< of 1 + K S Phi
};

}  // namespace steadyslide::numeric::variational
