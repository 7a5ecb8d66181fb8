#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "numeric/variational/fit_family.hpp"
#include "numeric/variational/local_fit.hpp"

namespace steadyslide::numeric::variational {
namespace {

/// Where the least squares left are least, by variable projection: lambda alone is searched for.
double best_exponent(std::span<const Bin> bins, LocalSeries series, double from, double to, double scaling) {
  const auto square = [&](double lambda) {
    series.exponent = lambda;
    return fitted(bins, series, scaling).square;
  };
  constexpr int bits = std::numeric_limits<double>::digits / 2;
  return boost::math::tools::brent_find_minima(square, from, to, bits).first;
}

/// The least of the minima that a walk through ]from, to[ meets: there may be several.
double best_of_walk(std::span<const Bin> bins, LocalSeries series, double from, double to, double scaling) {
  constexpr int steps = 24;
  const auto at = [&](int i) { return from + (to - from) * i / steps; };
  int least = 0;
  double square = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    series.exponent = at(i);
    const double here = fitted(bins, series, scaling).square;
    if (here < square) {
      square = here;
      least = i;
    }
  }
  return best_exponent(bins, series, at(std::max(least - 1, 0)), at(std::min(least + 1, steps)), scaling);
}

/// The slope of log|t| over log d. Series with poles know lambda but for an integer: this one decides it.
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
  const std::vector<FamilyMember> members = family(cells, place, sides);
  const double cell = cell_length(cells, place.x, side);
  FittedExponent result{summary({}), place.x};
  if (members.empty()) return result;

  // With a polynomial beside the power no slope says anything; but there a jump is, and |beta| < 1/2.
  const Window& window = members.front().window;
  double rough = 0;
  if (remainder < 0) {
    const Window near{window.from, std::max(window.to / 2, 5 * window.from)};
    rough = rough_exponent(gathered(cells, place.x, sides, near));
  }
  double width = remainder < 0 ? 0.4 : 0.5;

  for (int round = 0; round < (known == PlaceIs::exact ? 1 : 4); ++round) {
    std::vector<double> exponents;
    std::vector<double> steps;
    for (const FamilyMember& member : members) {
      const auto bins = gathered(cells, result.place, sides, member.window);
      LocalSeries series{.poles = member.poles, .terms = member.terms, .remainder = remainder};
      const double lambda = best_of_walk(bins, series, rough - width, rough + width, rough);
      series.exponent = lambda;
      const SeriesFit fit = fitted(bins, series, rough);
      if (fit.freedom <= 0) continue;
      exponents.push_back(lambda);
      steps.push_back(fit.first_pole / (lambda * fit.amplitude));
    }
    result.exponent = summary(exponents);
    if (result.exponent.convergence == Convergence::stalled) break;
    rough = result.exponent.value;
    width = 0.2;
    if (known == PlaceIs::to_one_cell) {
      result.place = std::clamp(result.place - summary(steps).value, place.x - 2 * cell, place.x + 2 * cell);
    }
  }
  return result;
}

}  // namespace steadyslide::numeric::variational
