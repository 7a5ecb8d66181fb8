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

  /// The least of the minima inside ]from, to[, of which there may be several; not a number if it is an end.
  double search(double from, double to) const {
    constexpr int steps = 16;
    const auto at = [&](int i) { return from + (to - from) * i / steps; };
    std::vector<double> squares;
    for (int i = 0; i <= steps; ++i) squares.push_back(fit(at(i)).square);
    const auto least = static_cast<int>(std::min_element(squares.begin(), squares.end()) - squares.begin());
    if (least == 0 || least == steps) return nan;
    constexpr int bits = std::numeric_limits<double>::digits / 2;
    const auto square = [&](double lambda) { return fit(lambda).square; };
    return boost::math::tools::brent_find_minima(square, at(least - 1), at(least + 1), bits).first;
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

/// The slope of log|t| over log d. A series with poles knows lambda but for an integer: this one decides it.
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

  // With a polynomial beside the power no slope says anything; but there a jump is, and |beta| < 1/2.
  double about = 0;
  double width = 0.5;
  if (remainder < 0) {
    const Window& window = members.front().window;
    about = rough_exponent(gathered(cells, place.x, sides, {window.from, std::max(window.to / 2, 5 * window.from)}));
    width = 0.4;
  }
  for (int i = 0; i < (known == PlaceIs::exact ? 1 : steps_to_place); ++i) {
    std::vector<double> exponents;
    std::vector<double> deviations;
    std::vector<double> steps;
    for (const FamilyMember& member : members) {
      const BestExponent best(gathered(cells, result.place.value, sides, member.window),
                              {.poles = member.poles, .terms = member.terms, .remainder = remainder}, about);
      exponents.push_back(best.search(about - width, about + width));
      deviations.push_back(best.deviation(exponents.back()));
      const SeriesFit fit = best.fit(exponents.back());
      steps.push_back(fit.first_pole / (exponents.back() * fit.amplitude));
    }
    result.exponent = summary(exponents);
    if (result.exponent.convergence == Convergence::stalled) break;
    result.exponent.error += summary(deviations).value;
    about = result.exponent.value;
    width = 0.1;
    if (known == PlaceIs::to_one_cell) {
      result.place = moved_place(cells, place.x, side, result.place.value, summary(steps));
    }
  }
  return result;
}

}  // namespace steadyslide::numeric::variational
