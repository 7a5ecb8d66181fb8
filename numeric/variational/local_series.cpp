#include "numeric/variational/local_series.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

namespace steadyslide::numeric::variational {
namespace {

// Bins end at this multiple of the distance they begin at, or one cell later.
constexpr double bin_ratio = 1.06;

/// The values of all columns at y, in the order poles, terms, remainder; y counts in units of `length` but for |y|.
void add_columns(const LocalSeries& series, Side side, double distance, double length, double weight,
                 Eigen::Ref<Eigen::VectorXd> row) {
  const double sign = side == Side::right ? 1 : -1;
  const double y = sign * distance / length;
  const double singular = series.exponent ? (side == Side::right ? series.right_factor : series.left_factor) *
                                                std::pow(distance, *series.exponent)
                                          : 1;
  const double beside = series.exponent ? 1 : std::log(distance) / std::numbers::pi + (sign > 0 ? series.s : 0);
  Eigen::Index column = 0;
  double value = weight * singular * std::pow(y, -series.poles);
  for (int k = -series.poles; k <= series.terms; ++k, value *= y) row(column++) += value;
  value = weight * beside;
  for (int j = 0; j <= series.remainder; ++j, value *= y) row(column++) += value;
}

/// Means over a bin: all columns are analytic there, and c is two lengths of a bin away at least.
void add_means(const LocalSeries& series, const Bin& bin, double length, Eigen::Ref<Eigen::VectorXd> row) {
  using Rule = boost::math::quadrature::gauss<double, 7>;
  const double middle = (bin.near + bin.far) / 2;
  const double half = (bin.far - bin.near) / 2;
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    const double x = Rule::abscissa()[i];
    const double weight = Rule::weights()[i] / 2;
    add_columns(series, bin.side, middle + half * x, length, weight, row);
    if (x != 0) add_columns(series, bin.side, middle - half * x, length, weight, row);
  }
}

}  // namespace

std::vector<Bin> gathered(const Cells& cells, double place, Side side, const Window& window) {
  const auto count = static_cast<std::ptrdiff_t>(cells.mean.size());
  const auto edge = [&](std::ptrdiff_t i) { return cells.edges[static_cast<std::size_t>(i)]; };
  const bool right = side == Side::right;
  const auto after = std::upper_bound(cells.edges.begin(), cells.edges.end(), place) - cells.edges.begin();
  const double logarithm = std::log(window.to / window.from);

  std::vector<Bin> result;
  double force = 0;
  double near = 0;
  for (std::ptrdiff_t i = right ? std::max<std::ptrdiff_t>(after - 1, 0) : std::min(after, count) - 1;
       i >= 0 && i < count; i += right ? 1 : -1) {
    const double begin = right ? edge(i) - place : place - edge(i + 1);
    const double end = right ? edge(i + 1) - place : place - edge(i);
    if (begin < window.from) continue;
    if (end > window.to) break;
    if (end - begin > begin / 2) return {};
    if (force == 0) near = begin;
    force += cells.mean[static_cast<std::size_t>(i)] * (end - begin);
    if (end < bin_ratio * near) continue;
    const double u = std::log(std::sqrt(near * end) / window.from) / logarithm;
    result.push_back({side, near, end, force / (end - near), u * (1 - u)});
    force = 0;
  }
  return result;
}

SeriesFit fitted(std::span<const Bin> bins, const LocalSeries& series, double scaling) {
  const Eigen::Index rows = static_cast<Eigen::Index>(bins.size());
  const Eigen::Index columns = series.poles + series.terms + 1 + series.remainder + 1;
  SeriesFit result;
  result.freedom = rows - columns;
  if (result.freedom <= 0) return result;

  double length = 0;
  for (const Bin& bin : bins) length = std::max(length, bin.far);
  Eigen::MatrixXd transposed = Eigen::MatrixXd::Zero(columns, rows);
  Eigen::VectorXd right(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Bin& bin = bins[static_cast<std::size_t>(i)];
    add_means(series, bin, length, transposed.col(i));
    const double factor = bin.weight * std::pow((bin.near + bin.far) / 2, -scaling);
    transposed.col(i) *= factor;
    right(i) = factor * bin.mean;
  }
  Eigen::MatrixXd matrix = transposed.transpose();
  const Eigen::VectorXd norms = matrix.colwise().norm();
  matrix.array().rowwise() /= norms.transpose().array();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(matrix);
  const Eigen::VectorXd solution = decomposition.solve(right);
  result.square = (right - matrix * solution).squaredNorm();
  const auto coefficient = [&](Eigen::Index j) { return solution(j) / norms(j); };
  result.amplitude = coefficient(series.poles);
  if (series.poles > 0) result.first_pole = coefficient(series.poles - 1) * length;
  if (series.remainder >= 0) result.remainder = coefficient(series.poles + series.terms + 1);
  return result;
}

}  // namespace steadyslide::numeric::variational
