// Periodic contact at places of the surface.

#include <algorithm>
#include <limits>

#include "numeric/number/mapped.hpp"
#include "numeric/periodic/periodic_solution.hpp"
#include "numeric/periodic/repeated_contact.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
TwoSided<R> on_both_sides(const Estimate<R>& value) {
  return {value, value};
}

}  // namespace

template <Real R>
Rational PeriodicSolution<R>::begin() const {
  const Indenter& indenter = problem_.indenter();
  const std::vector<Rational>& points = found_.points;
  if (indenter.left() <= points.front() && points.back() <= indenter.right()) return indenter.left();
  return (points.front() + points.back() - *problem_.body().period()) / 2;
}

template <Real R>
typename PeriodicSolution<R>::Place PeriodicSolution<R>::locate(const Rational& x) const {
  const Rational& period = *problem_.body().period();
  const std::vector<Rational>& points = found_.points;
  Place place{moved_into(x, begin(), period), gap(), false};
  if (place.x < points.front()) {
    place.from_left = to_real<R>(place.x + period - points.back());
    place.from_right = to_real<R>(points.front() - place.x);
    return place;
  }
  const auto next = std::upper_bound(points.begin(), points.end(), place.x);
  place.arc = static_cast<std::size_t>(next - points.begin()) - 1;
  place.from_left = to_real<R>(place.x - *(next - 1));
  place.from_right = to_real<R>((next == points.end() ? Rational(points.front() + period) : *next) - place.x);
  place.is_point = place.x == *(next - 1);
  return place;
}

template <Real R>
std::pair<Estimate<R>, Estimate<R>> PeriodicSolution<R>::profile(const Rational& x) const {
  const R angle = 2 * weight().wave_number() * to_real<R>(x - found_.origin);
  R height = 0, slope = 0, sizes = 0, slopes = 0;
  for (std::size_t n = 1; n <= found_.g.size(); ++n) {
    const auto& [cosine, sine] = found_.g[n - 1];
    const R wave = 2 * static_cast<double>(n) * weight().wave_number(), at = static_cast<double>(n) * angle;
    slope += cosine * cos(at) + sine * sin(at);
    height += (cosine * sin(at) - sine * cos(at)) / wave;
    const R size = abs(cosine) + abs(sine);
    slopes += size * (1 + abs(at));
    sizes += size * (1 + abs(at)) / wave;
  }
  return {{height, 4 * epsilon<R>() * sizes}, {slope, 4 * epsilon<R>() * slopes}};
}

template <Real R>
Estimate<R> PeriodicSolution<R>::part(const Place& place, Side end) const {
  PanelDensity<R> density = end == Side::left ? traction().density(place.arc, R(0), place.from_right)
                                              : traction().density(place.arc, place.from_left, R(0));
  // The difference of the arc and the other distance would lose the digits of a small one.
  density.panel.length = end == Side::left ? place.from_left : place.from_right;
  const Estimate<R> integral = tanh_sinh::panel_integral(density);
  return integral.widened(4 * relative_error(place.arc, place.from_left, place.from_right));
}

template <Real R>
Estimate<R> PeriodicSolution<R>::gap_at(const Place& place) const {
  if (place.is_point || place.arc != gap()) return {};
  // The slope of the gap is -c times value(). The nearer end of contact is taken.
  const bool left_end = place.from_left < place.from_right;
  return compliance_ * (left_end ? -part(place, Side::left) : part(place, Side::right));
}

template <Real R>
Sample<R> PeriodicSolution<R>::at_point(const Place& place) const {
  const std::size_t j = place.arc, last = gap(), before = (j + last - 1) % last;
  const bool gap_on_left = traction().has_gap() && j == 0;
  const auto limit = [&](Side side) -> Estimate<R> {
    // No contact on that side.
    if (traction().has_gap() && (side == Side::left ? j == 0 : j == last)) return {};
    const int sign = exponent(j).sign();
    if (sign > 0) return {};
    if (sign < 0) return {-infinity<R>(), R(0)};
    const std::size_t arc = side == Side::left ? before : j;
    const R length = weight().arc(arc), half = length / 2;
    const R t = side == Side::left ? traction().value(arc, length, R(0), false, true)
                                   : traction().value(arc, R(0), length, true);
    return Estimate<R>{t, R(0)}.widened(4 * relative_error(arc, half, half));
  };
  Sample<R> sample;
  sample.traction = {limit(Side::left), limit(Side::right)};
  sample.shear = {gap_on_left ? Estimate<R>{} : shear_of(problem_, piece(before), sample.traction.left),
                  j == last ? Estimate<R>{} : shear_of(problem_, piece(j), sample.traction.right)};
  sample.gap = Estimate<R>{};
  sample.slope = on_both_sides(compliance_ * profile(place.x).second);
  if (gap_on_left && !is_free(j)) sample.slope.left = {-infinity<R>(), R(0)};
  if (j == last && !is_free(j)) sample.slope.right = {infinity<R>(), R(0)};
  return sample;
}

template <Real R>
Sample<R> PeriodicSolution<R>::at(const Place& place) const {
  if (place.is_point) return at_point(place);
  Sample<R> sample;
  const auto value = Estimate<R>{traction().value(place.arc, place.from_left, place.from_right), R(0)}.widened(
      relative_error(place.arc, place.from_left, place.from_right));
  Estimate<R> slope = profile(place.x).second;
  if (place.arc == gap()) {
    slope += value;
    if (place.x <= end()) sample.gap = gap_at(place);
  } else {
    sample.traction = on_both_sides(value);
    sample.shear = on_both_sides(shear_of(problem_, piece(place.arc), value));
    sample.gap = Estimate<R>{};
  }
  sample.slope = on_both_sides(compliance_ * slope);
  return sample;
}

template <Real R>
Sample<R> PeriodicSolution<R>::at(const Rational& x) const {
  Sample<R> sample = at(locate(x));
  sample.x = to_real<R>(x);
  return sample;
}

template <Real R>
Estimate<R> PeriodicSolution<R>::shear_slope(const Place& place, const Sample<R>& sample) const {
  if (place.is_point) return {R(std::numeric_limits<double>::quiet_NaN()), infinity<R>()};
  const bool in_gap = place.arc == gap();
  const std::size_t own = !in_gap ? place.arc : place.from_left < place.from_right ? gap() - 1 : 0;
  const R ratio = to_real<R>(problem_.shear_ratio(piece(own))), gamma = to_real<R>(problem_.elasticity().gamma());
  const R period = weight().period();
  const Estimate<R>& t = sample.traction.left;
  const Estimate<R> hilbert =
      sample.slope.left / compliance_ - to_real<R>(problem_.coupled_friction(piece(own))) * t - mean_friction();
  Estimate<R> sum = ratio * hilbert + gamma * t + Estimate<R>{gamma * to_real<R>(problem_.load()) / period, R(0)};
  const PiecewiseTraction<R>& panels = this->panels();
  for (std::size_t k = 0; k < gap(); ++k) {
    const Rational exact = problem_.shear_ratio(piece(k)) - problem_.shear_ratio(piece(own));
    if (exact == 0) continue;
    const R difference = to_real<R>(exact);
    // The distances from x to the arc and from the arc to x, going right.
    const R to_arc = place.from_right + way(place.arc + 1, k);
    const R from_arc = place.from_left + way(k + 1, place.arc);
    const SurfacePlace<R> left = panels.segment(k).front().left, right = panels.segment(k).back().right;
    R integral = 0, size = 0;
    for (const TractionPanel<R>& panel : panels.segment(k)) {
      const R before = to_arc + (panel.left - left), behind = from_arc + (right - panel.right);
      TractionNodes<R> nodes;
      panels.append_nodes(panel, {R(0), panel.length, R(0), before, behind}, nodes);
      for (std::size_t i = 0; i < nodes.forces.size(); ++i) {
        const R to_node = before + nodes.from_left[i], from_node = behind + nodes.from_right[i];
        const R cotangent = to_node < from_node ? R(1 / tan(weight().wave_number() * to_node))
                                                : R(-1 / tan(weight().wave_number() * from_node));
        integral += nodes.forces[i] * cotangent;
        size += abs(nodes.forces[i] * cotangent) * (panel.error + 16 * epsilon<R>());
      }
    }
    sum += difference * Estimate<R>{integral / period, size / period};
  }
  return compliance_ * sum;
}

template <Real R>
DetailedSample<R> PeriodicSolution<R>::details(const Place& place) const {
  DetailedSample<R> result{at(place), {}, {}, {}, {}};
  const Rational origin = problem_.origin_of_displacement();
  const auto height = [&](const Place& there) { return compliance_ * profile(there.x).first - gap_at(there); };
  result.displacement = height(place) - height(locate(origin));
  result.shear_slope = on_both_sides(shear_slope(place, result));
  const auto load_before = [&](const Place& there) {
    Estimate<R> load;
    const bool before = there.x < found_.points.front();
    for (std::size_t k = 0; k < gap() && !before && k < there.arc; ++k) load += loads()[k];
    if (!there.is_point && there.arc != gap()) load += -part(there, Side::left);
    return load;
  };
  result.cumulative_load = load_before(place);
  if (const Place left = locate(problem_.indenter().left()); left.x != begin()) {
    result.cumulative_load = result.cumulative_load - load_before(left);
    if (place.x < left.x) result.cumulative_load += Estimate<R>{to_real<R>(problem_.load())};
  }
  const Rational x = moved_into(place.x, problem_.indenter().left(), *problem_.body().period());
  const FrictionProfile& friction = problem_.friction();
  if (x <= problem_.indenter().right())
    result.friction = {friction.piece(x, Side::left), friction.piece(x, Side::right)};
  return result;
}

template <Real R>
DetailedSample<R> PeriodicSolution<R>::details_at(const Rational& x) const {
  DetailedSample<R> result = details(locate(x));
  result.x = to_real<R>(x);
  return result;
}

template <Real R>
std::vector<Rational> PeriodicSolution<R>::sampled_places(int count) const {
  std::vector<Rational> result;
  const auto add = [&](const Rational& from, const Rational& to, int n) {
    for (int i = 0; i < n; ++i) {
      const auto [forth, back] = chebyshev_position<double>(i, n);
      result.push_back(forth < back ? Rational(from + (to - from) * Rational(forth))
                                    : Rational(to - (to - from) * Rational(back)));
    }
  };
  const std::vector<Rational>& points = found_.points;
  if (begin() < points.front()) add(begin(), points.front(), count);
  // One half of the places is divided equally between the arcs, the other half in proportion to their lengths.
  const Rational width = points.back() - points.front();
  const auto before = [&](std::size_t k) {
    const auto part = static_cast<double>(k) / static_cast<double>(gap());
    const auto length = to_real<double>((points[k] - points.front()) / width);
    return k == gap() ? count : static_cast<int>(count * (part + length) / 2);
  };
  for (std::size_t k = 0; k < gap(); ++k) add(points[k], points[k + 1], before(k + 1) - before(k));
  if (points.back() < end()) add(points.back(), end(), count);
  return result;
}

template <Real R>
std::vector<Sample<R>> PeriodicSolution<R>::samples(int count) const {
  return mapped(sampled_places(count), [this](const Rational& x) { return at(x); });
}

template <Real R>
std::vector<DetailedSample<R>> PeriodicSolution<R>::detailed_samples(int count) const {
  return mapped(sampled_places(count), [this](const Rational& x) { return details_at(x); });
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                   \
  template Rational PeriodicSolution<R>::begin() const;                                              \
  template typename PeriodicSolution<R>::Place PeriodicSolution<R>::locate(const Rational& x) const; \
  template Estimate<R> PeriodicSolution<R>::gap_at(const Place& place) const;                        \
  template Sample<R> PeriodicSolution<R>::at(const Rational& x) const;                               \
  template DetailedSample<R> PeriodicSolution<R>::details_at(const Rational& x) const;               \
  template std::vector<Rational> PeriodicSolution<R>::sampled_places(int count) const;               \
  template std::vector<Sample<R>> PeriodicSolution<R>::samples(int count) const;                     \
  template std::vector<DetailedSample<R>> PeriodicSolution<R>::detailed_samples(int count) const;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
