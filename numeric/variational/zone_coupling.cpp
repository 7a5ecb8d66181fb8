#include "numeric/variational/zone_coupling.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace steadyslide::numeric::variational {
namespace {

constexpr Eigen::Index points = ZoneCoupling::points;

/// Chebyshev's points of [-1, 1].
double node(Eigen::Index i) {
  return std::cos((2 * static_cast<double>(i) + 1) * std::numbers::pi / (2 * static_cast<double>(points)));
}

/// The polynomial that is 1 at node i and 0 at the others.
double lagrange(Eigen::Index i, double x) {
  double product = 1;
  for (Eigen::Index j = 0; j < points; ++j) {
    if (j != i) product *= (x - node(j)) / (node(i) - node(j));
  }
  return product;
}

/// Zones of fewer cells than points have matrices without an inverse.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  return Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(matrix).pseudoInverse();
}

/// No further apart than an eighth of the length, or a cell.
bool is_near(std::size_t a, std::size_t b, std::size_t length) {
  return (a > b ? a - b : b - a) <= std::max<std::size_t>(length / 8, 1);
}

}  // namespace

ZoneCoupling::ZoneCoupling(const GalerkinOperator& influence, double h, std::span<const std::size_t> cells,
                           std::span<const CellRange> zones, const Map& product, const Map& inverse,
                           const ZoneCoupling* last)
    : surface_(influence.kernel()), h_(h), sign_(influence.friction().sign), lu_(Matrix()) {
  const auto size = static_cast<Eigen::Index>(cells.size());
  interpolation_.resize(size, points);
  responses_.resize(size, points);
  Eigen::Index k = 0;
  for (const CellRange& range : zones) {
    const double half = static_cast<double>(range.count) / 2;
    Zone& zone = zones_.emplace_back(Zone{range, h * (static_cast<double>(range.first) + half), h * half, k});
    for (; k < size && cells[static_cast<std::size_t>(k)] < range.first + range.count; ++k) {
      const double x = (static_cast<double>(cells[static_cast<std::size_t>(k)] - range.first) + 0.5) / half - 1;
      for (Eigen::Index i = 0; i < points; ++i) interpolation_(k, i) = lagrange(i, x);
    }
    zone.count = k - zone.first;
  }
  for (Eigen::Index i = 0; i < points; ++i) responses_.col(i) = inverse(interpolation_.col(i));
  for (Zone& zone : zones_) {
    const auto t = interpolation_.middleRows(zone.first, zone.count);
    const auto phi = responses_.middleRows(zone.first, zone.count);
    zone.moments = h * t.transpose() * phi;
    double force = 0;
    for (Eigen::Index j = 0; j < zone.count; ++j) {
      force += influence.friction().whole[cells[static_cast<std::size_t>(zone.first + j)]] * phi.row(j).sum();
    }
    zone.friction = force / (h * phi.sum());
  }
  if (last && fits(*last)) {
    k_ = last->k_;
  } else {
    make_kernel(product);
  }
  Matrix system = k_;
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    system.middleCols<points>(row(z)) = k_.middleCols<points>(row(z)) * zones_[z].moments;
  }
  system.diagonal().array() += 1;
  lu_ = DenseLu(system);
}

bool ZoneCoupling::fits(const ZoneCoupling& other) const {
  const auto are_near = [](const Zone& a, const Zone& b) {
    const auto [first, count] = a.cells;
    return is_near(first, b.cells.first, count) && is_near(first + count, b.cells.first + b.cells.count, count);
  };
  return std::equal(zones_.begin(), zones_.end(), other.zones_.begin(), other.zones_.end(), are_near);
}

ZoneCoupling::Block ZoneCoupling::kernel(const Zone& at, const Zone& from) const {
  Block result;
  for (Eigen::Index i = 0; i < points; ++i) {
    for (Eigen::Index j = 0; j < points; ++j) {
      const double distance = at.centre + at.half * node(i) - from.centre - from.half * node(j);
      const bool felt = sign_ * distance > 0;
      result(i, j) = surface_.at(distance) + (felt ? sign_ * from.friction : 0);
    }
  }
  return result;
}

void ZoneCoupling::make_kernel(const Map& product) {
  Matrix left_out(responses_.rows(), points);
  for (Eigen::Index i = 0; i < points; ++i) left_out.col(i) = product(responses_.col(i)) - interpolation_.col(i);
  const auto n = row(zones_.size());
  k_.resize(n, n);
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const Zone& zone = zones_[z];
    const auto t = interpolation_.middleRows(zone.first, zone.count);
    Block own = pseudo_inverse(t.transpose() * t) * (t.transpose() * left_out.middleRows(zone.first, zone.count));
    for (std::size_t w = 0; w < zones_.size(); ++w) {
      if (w == z) continue;
      const Block block = kernel(zone, zones_[w]);
      k_.block<points, points>(row(z), row(w)) = block;
      own -= block * zones_[w].moments;
    }
    k_.block<points, points>(row(z), row(z)) = own * pseudo_inverse(zone.moments);
  }
}

void ZoneCoupling::correct(Vector& p) const {
  Vector loads(k_.rows());
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const Zone& zone = zones_[z];
    loads.segment<points>(row(z)) =
        h_ * interpolation_.middleRows(zone.first, zone.count).transpose() * p.segment(zone.first, zone.count);
  }
  const Vector values = lu_.solve(Vector(k_ * loads));
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const Zone& zone = zones_[z];
    p.segment(zone.first, zone.count).noalias() -=
        responses_.middleRows(zone.first, zone.count) * values.segment<points>(row(z));
  }
}

}  // namespace steadyslide::numeric::variational
