#include "numeric/variational/surface_inverse.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <tuple>

namespace steadyslide::numeric::variational {
namespace {

/// Each kind of cells costs a transform; close values of s share one kind.
constexpr std::size_t most_kinds = 4;
/// With a diagonal, a kind in place of another one costs more products than its own transform.
constexpr std::size_t most_kinds_with_diagonal = 64;

/// Returns a fast length of at least 9/8 of the cells. There are three in an octave, so plans and symbols are shared.
std::size_t circle_length(std::size_t cells) {
  const std::size_t least = std::max<std::size_t>(cells + cells / 8, 16);
  const std::size_t octave = std::bit_floor(least);
  for (const std::size_t quarters : {4U, 5U, 6U}) {
    if (octave / 4 * quarters >= least) return octave / 4 * quarters;
  }
  return 2 * octave;
}

constexpr Eigen::Index points = ZoneCoupling::points;

/// Returns Chebyshev's point i of [-1, 1].
double node(Eigen::Index i) {
  return std::cos((2 * static_cast<double>(i) + 1) * std::numbers::pi / (2 * static_cast<double>(points)));
}

/// Returns the polynomial that is 1 at node i and 0 at the others.
double lagrange(Eigen::Index i, double x) {
  double product = 1;
  for (Eigen::Index j = 0; j < points; ++j) {
    if (j != i) product *= (x - node(j)) / (node(i) - node(j));
  }
  return product;
}

/// Returns the pseudo-inverse, because zones with fewer cells than points have singular matrices.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix) {
  return Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(matrix).pseudoInverse();
}

/// True if the distance is at most an eighth of the length, or one cell.
bool is_near(std::size_t a, std::size_t b, std::size_t length) {
  return (a > b ? a - b : b - a) <= std::max<std::size_t>(length / 8, 1);
}

}  // namespace

std::vector<SurfaceInverse::Kind> SurfaceInverse::representatives(std::vector<Kind> cells) {
  const std::vector<Kind> all = cells;
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());  // so that few are left to sort
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  const bool has_diagonal =
      std::any_of(cells.begin(), cells.end(), [](const Kind& cell) { return cell.diagonal != 0; });
  if (cells.size() <= (has_diagonal ? most_kinds_with_diagonal : most_kinds)) return cells;
  const bool has_ends = std::any_of(cells.begin(), cells.end(), [](const Kind& cell) { return cell.at_end; });
  const double low = std::atan(cells.front().s);
  const double width = (std::atan(cells.back().s) - low) / most_kinds;
  std::vector<double> sums(most_kinds), counts(most_kinds);
  for (const Kind& cell : all) {
    const double group = width > 0 ? (std::atan(cell.s) - low) / width : 0;
    const std::size_t k = std::min(static_cast<std::size_t>(group), most_kinds - 1);
    sums[k] += cell.diagonal;
    ++counts[k];
  }
  std::vector<Kind> result;
  for (std::size_t k = 0; k < most_kinds; ++k) {
    const double diagonal = counts[k] > 0 ? sums[k] / counts[k] : 0;
    const double s = std::tan(low + (static_cast<double>(k) + 0.5) * width);
    result.push_back({s, has_ends && std::abs(s) > strong_friction, diagonal});
  }
  return result;
}

SurfaceInverse::SurfaceInverse(const GalerkinOperator& influence, double length)
    : influence_(influence), length_(length), kind_of_(influence.size()), pressures_(influence.size()) {
  std::vector<Kind> cells;
  // In single precision, so that cells that differ by rounding have one kind.
  const auto rounded = [](double value) { return static_cast<double>(static_cast<float>(value)); };
  for (std::size_t i = 0; i < influence.size(); ++i) {
    const CellFriction& friction = influence.friction();
    cells.push_back({rounded(friction.whole[i] / length), friction.is_at_end(i), rounded(influence.diagonal(i))});
  }
  kinds_ = representatives(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0 && cells[i] == cells[i - 1]) {
      kind_of_[i] = kind_of_[i - 1];
      continue;
    }
    const auto distance = [&](const Kind& kind) {
      return std::tuple(std::abs(std::atan(kind.s) - std::atan(cells[i].s)), kind.at_end != cells[i].at_end,
                        std::abs(kind.diagonal - cells[i].diagonal));
    };
    const auto nearest = std::min_element(kinds_.begin(), kinds_.end(),
                                          [&](const Kind& a, const Kind& b) { return distance(a) < distance(b); });
    kind_of_[i] = static_cast<unsigned char>(nearest - kinds_.begin());
  }
}

std::vector<std::complex<double>> SurfaceInverse::reciprocal(const Kind& kind, const Fourier& fourier) const {
  const double s = kind.s;
  const CellFriction& friction = influence_.friction();
  const double rest = kind.at_end ? friction.sign * 0.5 : 0;
  std::vector<std::complex<double>> result = influence_.spectrum(kind.at_end, length_, fourier);
  const auto n = static_cast<double>(fourier.size());
  for (std::size_t k = 0; k < result.size(); ++k) {
    const double cot = k == 0 ? 0 : 1 / std::tan(std::numbers::pi * static_cast<double>(k) / n);
    // The sum over the cells before plus half of the cell itself has the symbol -i h/2 cot(theta/2).
    const double wave_number = 2 * std::numbers::pi * static_cast<double>(k) / (n * length_);
    const double turned =
        k == 0 ? s : friction.shift + (s - friction.shift) * influence_.kernel().symbols(wave_number).second;
    const std::complex<double> symbol = result[k] + kind.diagonal + turned * length_ * std::complex(rest, -cot / 2);
    result[k] = std::conj(symbol) / std::norm(symbol);
  }
  return result;
}

void SurfaceInverse::restrict_to(const std::vector<CellRange>& zones) {
  zones_.clear();
  for (const CellRange& cells : zones) {
    const std::size_t length = circle_length(cells.count);
    Circle& circle = circles_.try_emplace(length, length).first->second;
    Zone& zone = zones_.emplace_back(Zone{cells, &circle, {}});
    for (std::size_t i = cells.first; i < cells.first + cells.count; ++i) {
      if (std::find(zone.kinds.begin(), zone.kinds.end(), kind_of_[i]) == zone.kinds.end())
        zone.kinds.push_back(kind_of_[i]);
    }
    for (const unsigned char kind : zone.kinds) {
      if (!circle.reciprocals.contains(kind)) circle.reciprocals[kind] = reciprocal(kinds_[kind], circle.fourier);
    }
  }
}

void SurfaceInverse::apply(std::span<const double> r, std::span<double> p) {
  for (const Zone& zone : zones_) {
    const Fourier& fourier = zone.circle->fourier;
    const std::span<double> values = fourier.values();
    const auto [first, count] = zone.cells;
    std::copy_n(r.begin() + static_cast<std::ptrdiff_t>(first), count, values.begin());
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(count), values.end(), 0);
    fourier.forward();
    for (const unsigned char kind : zone.kinds) {
      const std::vector<std::complex<double>>& reciprocal = zone.circle->reciprocals.at(kind);
      if (kind == zone.kinds.front()) {
        fourier.convolve(reciprocal, p.subspan(first, count));
        continue;
      }
      fourier.convolve(reciprocal, std::span(pressures_).first(count));
      for (std::size_t i = 0; i < count; ++i) {
        if (kind_of_[first + i] == kind) p[first + i] = pressures_[i];
      }
    }
  }
}

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
