#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "numeric/variational/fit_family.hpp"
#include "numeric/variational/local_fit.hpp"

namespace steadyslide::numeric::variational {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Where the least squares left are least, by variable projection: a search for lambda alone, all else is linear.
class BestExponent {
 public:
  BestExponent(std::vector<Bin> bins, const LocalSeries& series, double scaling)
      : bins_(std::move(bins)), series_(series), scaling_(scaling) {}

  SeriesFit fit(double lambda) const {
    LocalSeries series = series_;
    series.exponent = lambda;
    return fitted(bins_, series, scaling_);
  }

  /// The least of the minima inside ]from, to[, of which there may be several; not a number if there is none.
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

  /// The same in ]-1, 1[ for a power that stands alone. With poles lambda is known but for an integer: c_-1/c_0 decides
  /// it, a length. What cells make of it is a part of their length `cell`, a leading term is more; not a number
  /// between.
  double search_alone(double cell) const {
    const double lambda = search(-0.15, 1.15);
    const SeriesFit found = fit(lambda);
    const double length = std::abs(found.first_pole / found.amplitude);
    if (length < 2 * cell) return lambda;
    return length > 6 * cell ? search(lambda - 1.15, lambda - 0.85) : nan;
  }

  /// The standard deviation of lambda if what is left were independent noise.
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

/// The slope of log|t| over log d: what rows are scaled by.
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

}  // namespace

FittedExponent fitted_exponent(const Cells& cells, const LocalPlace& place, Side side, int remainder, PlaceIs known) {
  const Side sides[] = {side};
  const std::vector<FamilyMember> members = family(cells, place, sides, remainder >= 0);
  FittedExponent result{summary({}), {place.x, 0}};
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
    result.exponent = summary(exponents);
    if (result.exponent.convergence == Convergence::stalled) break;
    result.exponent.error += summary(deviations).value;
    about = result.exponent.value;
    if (known == PlaceIs::to_one_cell) {
      result.place = moved_place(cells, place.x, side, result.place.value, summary(steps));
    }
  }
  return result;
}

}  // namespace steadyslide::numeric::variational
