#pragma once
// An approximate inverse of the operator B on cells of a uniform mesh, by Fourier transforms. On an infinite line with
// one friction value, B is a convolution and the reciprocal of its symbol is exact, also with a constant diagonal. Here
// each cell uses the reciprocal for its own s and diagonal. The kernel of the inverse decreases like the inverse square
// of the distance. So the line may be closed to a circle soon behind the cells, and separate zones are inverted
// separately, by transforms not much longer than the zone.

#include <Eigen/Core>
#include <compare>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "numeric/number/dense_lu.hpp"
#include "numeric/variational/galerkin_operator.hpp"

namespace steadyslide::numeric::variational {

/// A range of neighbouring cells.
struct CellRange {
  std::size_t first;
  std::size_t count;
};

class SurfaceInverse {
 public:
  /// `length` is the length of a cell. The operator must outlive this object.
  SurfaceInverse(const GalerkinOperator& influence, double length);
  /// Restricts the inverse to pressures on these cells.
  void restrict_to(const std::vector<CellRange>& zones);
  /// Computes the pressure whose displacement is approximately r (both over all cells), separately in each zone; up to
  /// a constant of r in each zone, which the other zones and the zone's own load cause.
  void apply(std::span<const double> r, std::span<double> p);

 private:
  /// The transforms of one length.
  struct Circle {
    Fourier fourier;
    std::map<unsigned char, std::vector<std::complex<double>>> reciprocals;  ///< 1/symbol by the kind of cells

    explicit Circle(std::size_t length) : fourier(length) {}
  };
  struct Zone {
    CellRange cells;
    Circle* circle;
    std::vector<unsigned char> kinds;  ///< the kinds of its cells
  };
  /// The data of a cell on which the symbol depends.
  struct Kind {
    double s;
    bool at_end;  ///< the equation applies at the cell's end
    double diagonal;
    auto operator<=>(const Kind&) const = default;
  };
  std::vector<std::complex<double>> reciprocal(const Kind& kind, const Fourier& fourier) const;
  /// Returns the kinds that occur; if there are too many, groups of them by s with the mean diagonal.
  static std::vector<Kind> representatives(std::vector<Kind> cells);

  const GalerkinOperator& influence_;
  double length_;
  std::vector<Kind> kinds_;
  std::vector<unsigned char> kind_of_;  ///< for each cell, the index of the kind that is nearest to it
  std::map<std::size_t, Circle> circles_;
  std::vector<Zone> zones_;
  std::vector<double> pressures_;  ///< work space
};

/// The coupling of contact zones, for an approximate inverse M^-1 that inverts each zone separately. From outside, a
/// zone is represented by a few Chebyshev points: S p are the loads there, T y interpolates between values there, and
///
///   B ~ M + T K S,   (M + T K S)^-1 = M^-1 - Phi (1 + K S Phi)^-1 K S M^-1,   Phi = M^-1 T,
///
/// where K is the kernel between points of different zones. Its diagonal blocks are the part of B that M omits: M is
/// only correct up to a constant. Without the coupling, each zone costs about one more step of Krylov's method.
class ZoneCoupling {
 public:
  using Vector = Eigen::VectorXd;
  using Map = std::function<Vector(const Vector&)>;
  /// The number of points of a zone, which is also the number of products.
  static constexpr Eigen::Index points = 3;

  /// Vectors are over `cells`, in increasing order. Each cell is in one of the zones, which are also in increasing
  /// order. h is the length of a cell. If the zones of `last` are nearly the same, its K is reused.
  ZoneCoupling(const GalerkinOperator& influence, double h, std::span<const std::size_t> cells,
               std::span<const CellRange> zones, const Map& product, const Map& inverse, const ZoneCoupling* last);
  /// Changes p from M^-1 r to (M + T K S)^-1 r.
  void correct(Vector& p) const;

 private:
  using Matrix = Eigen::MatrixXd;
  using Block = Eigen::Matrix<double, points, points>;
  struct Zone {
    CellRange cells;
    double centre;
    double half;             ///< half the length of the zone
    Eigen::Index first = 0;  ///< first entry in vectors
    Eigen::Index count = 0;
    Block moments = Block::Zero();  ///< S Phi
    double friction = 0;            ///< s of the zone
  };
  static Eigen::Index row(std::size_t zone) { return points * static_cast<Eigen::Index>(zone); }
  bool fits(const ZoneCoupling& other) const;
  /// Returns K between points of different zones.
  Block kernel(const Zone& at, const Zone& from) const;
  void make_kernel(const Map& product);

  SurfaceKernel surface_;
  double h_;
  double sign_;
  std::vector<Zone> zones_;
  Matrix interpolation_;  ///< T; all zones share the columns
  Matrix responses_;      ///< Phi, likewise
  Matrix k_;
  DenseLu lu_;  ///< of 1 + K S Phi
};

}  // namespace steadyslide::numeric::variational
