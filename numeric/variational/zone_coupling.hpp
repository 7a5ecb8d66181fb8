#pragma once
// What zones of contact do to each other, for an approximate inverse M^-1 that takes each of them by itself. From outside a
// zone is seen at a few points of it alone, Chebyshev's: S p are the loads there, T y is interpolated between values there, and
//
//   B = M + T K S, nearly,   (M + T K S)^-1 = M^-1 - Phi (1 + K S Phi)^-1 K S M^-1,   Phi = M^-1 T,
//
// where K is the kernel between points of different zones. Its blocks for a zone alone are what B does and M leaves out: M
// knows no constant. Without it each zone costs about one more step of Krylov's method.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>

#include "numeric/number/dense_lu.hpp"
#include "numeric/variational/surface_inverse.hpp"

namespace steadyslide::numeric::variational {

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
