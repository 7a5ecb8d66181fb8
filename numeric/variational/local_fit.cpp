#include "numeric/variational/local_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

namespace steadyslide::numeric::variational {
namespace {

// A bin ends at this multiple of the distance of its start, or one cell later.
constexpr double bin_ratio = 1.06;

/// Adds the values of all columns at y, in the order poles, terms, remainder. y is in units of `length`, except in |y|.
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

/// Adds the means over a bin. All columns are analytic there, and c is at least two bin lengths away.
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
  const auto rows = static_cast<Eigen::Index>(bins.size());
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

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A window and a series. The spread of the fits of a family is the error of a result.
struct FamilyMember {
  Window window;
  int poles;
  int terms;
};

/// Returns the length of the cell next to c on that side.
double cell_length(const Cells& cells, double place, Side side) {
  const auto after = std::upper_bound(cells.edges.begin() + 1, cells.edges.end() - 1, place);
  // If the place is a cell edge: the cell on its right and the cell on its left.
  const auto right =
      side == Side::left && *(after - 1) == place && after - 1 != cells.edges.begin() ? after - 1 : after;
  return *right - *(right - 1);
}

/// Returns the family for these sides. The windows are the same on both sides. `crowded`: there is an unknown exponent
/// beside a polynomial, which leaves fewer terms to choose; the family has fewer members.
std::vector<FamilyMember> family(const Cells& cells, const LocalPlace& place, std::span<const Side> sides,
                                 bool crowded = false) {
  double cell = 0;
  double reach = std::numeric_limits<double>::infinity();
  for (const Side side : sides) {
    cell = std::max(cell, cell_length(cells, place.x, side));
    const bool right = side == Side::right;
    reach = std::min({reach, right ? place.right : place.left, 4 * (right ? place.left : place.right),
                      right ? cells.edges.back() - place.x : place.x - cells.edges.front()});
  }
  std::vector<FamilyMember> result;
  for (const double part : {0.3, 0.4, 0.5}) {
    for (const double from : {10., 16., 24.}) {
      const Window window{from * cell, part * reach};
      if (window.to < 6 * window.from || (crowded && from == 10)) continue;
      for (const int terms : {7, 9, 11}) {
        result.push_back({window, 2, terms});
        if (!crowded) result.push_back({window, 3, terms});
      }
    }
  }
  return result;
}

/// Returns the window's cells on all sides.
std::vector<Bin> gathered(const Cells& cells, double place, std::span<const Side> sides, const Window& window) {
  std::vector<Bin> result;
  for (const Side side : sides) {
    const std::vector<Bin> bins = gathered(cells, place, side, window);
    if (bins.empty()) return {};
    result.insert(result.end(), bins.begin(), bins.end());
  }
  return result;
}

/// Returns the place of a free end after a Newton step from x. At the exact place the first pole vanishes; `step` is
/// c_-1/(lambda c_0) at x. The error is the square of the step. The result stays within two cells of `start`.
Estimate<double> moved_place(const Cells& cells, double start, Side side, double x, const Estimate<double>& step) {
  if (step.convergence == Convergence::stalled) return {start, step.error, Convergence::stalled};
  const double most = 2 * cell_length(cells, start, side);
  return {std::clamp(x - step.value, start - most, start + most), step.error};
}

constexpr int steps_to_place = 4;

/// Finds the lambda with the least sum of squares, by variable projection: only lambda is searched, the other unknowns
/// are linear.
class BestExponent {
 public:
  BestExponent(std::vector<Bin> bins, const LocalSeries& series, double scaling)
      : bins_(std::move(bins)), series_(series), scaling_(scaling) {}

  SeriesFit fit(double lambda) const {
    LocalSeries series = series_;
    series.exponent = lambda;
    return fitted(bins_, series, scaling_);
  }

  /// Returns the lowest of the minima inside ]from, to[, of which there may be several; NaN if there is none.
  double search(double from, double to) const {
    const int steps = 4 + static_cast<int>(16 * (to - from));
    const auto at = [&](int i) { return from + (to - from) * i / steps; };
    std::vector<double> squares;
    for (int i = 0; i <= steps; ++i) squares.push_back(fit(at(i)).square);
    int least = 0;
    for (int i = 1; i < steps; ++i) {
      const auto at_step = [&](int k) { return squares[static_cast<std::size_t>(k)]; };
      const bool valley = at_step(i) < at_step(i - 1) && at_step(i) <= at_step(i + 1);
      if (valley && (least == 0 || at_step(i) < at_step(least))) least = i;
    }
    if (least == 0) return nan;
    constexpr int bits = std::numeric_limits<double>::digits / 2;
    const auto square = [&](double lambda) { return fit(lambda).square; };
    return boost::math::tools::brent_find_minima(square, at(least - 1), at(least + 1), bits).first;
  }

  /// The same in ]-1, 1[ for a power without a polynomial. With poles, lambda is known up to an integer. The length
  /// c_-1/c_0 decides this integer: if c_-1 is an error of the cells, this length is a fraction of the cell length
  /// `cell`; if it is a leading term, the length is larger. NaN in between.
  double search_alone(double cell) const {
    const double lambda = search(-0.15, 1.15);
    const SeriesFit found = fit(lambda);
    const double length = std::abs(found.first_pole / found.amplitude);
    if (length < 2 * cell) return lambda;
    return length > 6 * cell ? search(lambda - 1.15, lambda - 0.85) : nan;
  }

  /// Returns the standard deviation of lambda if the residuals were independent noise.
  double deviation(double lambda) const {
    constexpr double step = 1e-3;
    const SeriesFit here = fit(lambda);
    const double curvature = (fit(lambda - step).square - 2 * here.square + fit(lambda + step).square) / (step * step);
    return std::sqrt(2 * here.square / (static_cast<double>(here.freedom) * curvature));
  }

 private:
  std::vector<Bin> bins_;
  LocalSeries series_;
  double scaling_;
};

/// Returns the slope of log|t| over log d, which scales the rows.
double rough_exponent(std::span<const Bin> bins) {
  double weights = 0;
  double x_mean = 0;
  double y_mean = 0;
  double xx = 0;
  double xy = 0;
  for (const Bin& bin : bins) {
    if (bin.mean == 0) continue;
    const double x = std::log((bin.near + bin.far) / 2);
    const double y = std::log(std::abs(bin.mean));
    weights += bin.weight;
    const double dx = x - x_mean;
    x_mean += dx * bin.weight / weights;
    y_mean += (y - y_mean) * bin.weight / weights;
    xx += bin.weight * dx * (x - x_mean);
    xy += bin.weight * dx * (y - y_mean);
  }
  return xy / xx;
}

/// A family of fits of one series with different numbers of terms.
class Fits {
 public:
  Fits(const Cells& cells, double x, std::span<const Side> sides, std::span<const FamilyMember> members,
       LocalSeries series) {
    for (const FamilyMember& member : members) {
      series.poles = member.poles;
      series.terms = member.terms;
      fits_.push_back(fitted(gathered(cells, x, sides, member.window), series, series.exponent.value_or(0)));
    }
  }

  template <class F>
  Estimate<double> summary(const F& value) const {
    std::vector<double> values;
    for (const SeriesFit& fit : fits_) values.push_back(value(fit));
    return of_family(std::move(values));
  }

 private:
  std::vector<SeriesFit> fits_;
};

double theta(const SeriesFit& fit) { return -fit.amplitude; }
double remainder(const SeriesFit& fit) { return fit.remainder; }

}  // namespace

Estimate<double> of_family(std::vector<double> values, std::vector<double> deviations) {
  const std::size_t asked = values.size();
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.size() < 3 || 3 * values.size() < 2 * asked) {
    return {nan, std::numeric_limits<double>::infinity(), Convergence::stalled};
  }
  std::sort(values.begin(), values.end());
  Estimate<double> result{values[values.size() / 2], values.back() - values.front(), Convergence::reached};
  if (!deviations.empty()) result.error += of_family(std::move(deviations)).value;
  return result;
}

FittedExponent fitted_exponent(const Cells& cells, const LocalPlace& place, Side side, int remainder, PlaceIs known) {
  const Side sides[] = {side};
  const std::vector<FamilyMember> members = family(cells, place, sides, remainder >= 0);
  FittedExponent result{of_family({}), {place.x, 0}};
  if (members.empty()) return result;

  const double cell = cell_length(cells, place.x, side);
  double about = rough_exponent(gathered(cells, place.x, sides, members.front().window));
  for (int i = 0; i < (known == PlaceIs::exact ? 1 : steps_to_place); ++i) {
    std::vector<double> exponents;
    std::vector<double> deviations;
    std::vector<double> steps;
    for (const FamilyMember& member : members) {
      const BestExponent best(gathered(cells, result.place.value, sides, member.window),
                              {.poles = member.poles, .terms = member.terms, .remainder = remainder}, about);
      const double lambda = i > 0            ? best.search(about - 0.2, about + 0.2)
                            : remainder >= 0 ? best.search(-0.5, 0.5)
                                             : best.search_alone(cell);
      const SeriesFit fit = best.fit(lambda);
      exponents.push_back(lambda);
      deviations.push_back(best.deviation(lambda));
      steps.push_back(fit.first_pole / (lambda * fit.amplitude));
    }
    result.exponent = of_family(exponents, deviations);
    if (result.exponent.convergence == Convergence::stalled) break;
    about = result.exponent.value;
    if (known == PlaceIs::to_one_cell) {
      result.place = moved_place(cells, place.x, side, result.place.value, of_family(steps));
    }
  }
  return result;
}

FittedIntensity fitted_end(const Cells& cells, const LocalPlace& place, Side contact, double exponent, PlaceIs known) {
  const Side sides[] = {contact};
  const std::vector<FamilyMember> members = family(cells, place, sides);
  const LocalSeries series{.exponent = exponent};
  if (known == PlaceIs::exact) {
    return {Fits(cells, place.x, sides, members, series).summary(theta), {}, {place.x, 0}};
  }
  Estimate<double> x{place.x, 0};
  for (int i = 0; i < steps_to_place; ++i) {
    const Fits fits(cells, x.value, sides, members, series);
    x = moved_place(cells, place.x, contact, x.value,
                    fits.summary([&](const SeriesFit& fit) { return fit.first_pole / (exponent * fit.amplitude); }));
  }
  return {Fits(cells, x.value, sides, members, series).summary(theta), {}, x};
}

FittedIntensity fitted_jump(const Cells& cells, const LocalPlace& place, double exponent, double cos_left,
                            double cos_right, int wedge) {
  const Side sides[] = {Side::left, Side::right};
  const LocalSeries series{
      .exponent = exponent, .left_factor = cos_left, .right_factor = cos_right, .remainder = wedge};
  const Fits fits(cells, place.x, sides, family(cells, place, sides), series);
  return {fits.summary(theta), wedge >= 0 ? fits.summary(remainder) : Estimate<double>{}, {place.x, 0}};
}

FittedIntensity fitted_wedge(const Cells& cells, const LocalPlace& place, double s, int wedge) {
  const Side sides[] = {Side::left, Side::right};
  const LocalSeries series{.s = s, .remainder = wedge};
  const Fits fits(cells, place.x, sides, family(cells, place, sides), series);
  return {fits.summary(remainder), fits.summary([](const SeriesFit& fit) { return fit.amplitude; }), {place.x, 0}};
}

}  // namespace steadyslide::numeric::variational
