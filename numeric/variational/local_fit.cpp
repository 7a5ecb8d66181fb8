#include "numeric/variational/local_fit.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/variational/fit_family.hpp"

namespace steadyslide::numeric::variational {
namespace {

/// All members fitted with one series but for its number of terms.
std::vector<SeriesFit> fits(const Cells& cells, double x, std::span<const Side> sides,
                            std::span<const FamilyMember> members, LocalSeries series) {
  std::vector<SeriesFit> result;
  for (const FamilyMember& member : members) {
    series.poles = member.poles;
    series.terms = member.terms;
    const SeriesFit fit = fitted(gathered(cells, x, sides, member.window), series, series.exponent.value_or(0));
    if (fit.freedom > 0) result.push_back(fit);
  }
  return result;
}

template <class F>
Estimate<double> summary(const std::vector<SeriesFit>& fits, const F& value) {
  std::vector<double> values;
  for (const SeriesFit& fit : fits) values.push_back(value(fit));
  return variational::summary(std::move(values));
}

}  // namespace

FittedIntensity fitted_end(const Cells& cells, const LocalPlace& place, Side contact, double exponent, PlaceIs known) {
  const Side sides[] = {contact};
  const std::vector<FamilyMember> members = family(cells, place, sides);
  double x = place.x;
  const LocalSeries series{.exponent = exponent};
  // About the right place the first pole vanishes; Newton's steps, of which one leaves the square of the distance.
  if (known == PlaceIs::to_one_cell) {
    for (int i = 0; i < 4; ++i) {
      const Estimate<double> step = summary(fits(cells, x, sides, members, series), [&](const SeriesFit& fit) {
        return fit.first_pole / (exponent * fit.amplitude);
      });
      if (step.convergence == Convergence::stalled) break;
      const double cell = cell_length(cells, place.x, contact);
      x = std::clamp(x - step.value, place.x - 2 * cell, place.x + 2 * cell);
    }
  }
  const auto found = fits(cells, x, sides, members, series);
  return {summary(found, [](const SeriesFit& fit) { return -fit.amplitude; }), {}, x};
}

FittedIntensity fitted_jump(const Cells& cells, const LocalPlace& place, double exponent, double cos_left,
                            double cos_right, int wedge) {
  const Side sides[] = {Side::left, Side::right};
  const auto found =
      fits(cells, place.x, sides, family(cells, place, sides),
           {.exponent = exponent, .left_factor = cos_left, .right_factor = cos_right, .remainder = wedge});
  FittedIntensity result{summary(found, [](const SeriesFit& fit) { return -fit.amplitude; }), {}, place.x};
  if (wedge >= 0) result.constant = summary(found, [](const SeriesFit& fit) { return fit.remainder; });
  return result;
}

FittedIntensity fitted_wedge(const Cells& cells, const LocalPlace& place, double s, int wedge) {
  const Side sides[] = {Side::left, Side::right};
  const auto found = fits(cells, place.x, sides, family(cells, place, sides), {.s = s, .remainder = wedge});
  return {summary(found, [](const SeriesFit& fit) { return fit.remainder; }),
          summary(found, [](const SeriesFit& fit) { return fit.amplitude; }), place.x};
}

}  // namespace steadyslide::numeric::variational
