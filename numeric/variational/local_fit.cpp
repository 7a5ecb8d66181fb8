#include "numeric/variational/local_fit.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/variational/fit_family.hpp"

namespace steadyslide::numeric::variational {
namespace {

/// A family of fits of one series, but for its number of terms.
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
    return variational::summary(std::move(values));
  }

 private:
  std::vector<SeriesFit> fits_;
};

double theta(const SeriesFit& fit) { return -fit.amplitude; }
double remainder(const SeriesFit& fit) { return fit.remainder; }

}  // namespace

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
