// What integrals of the traction add to the solution at a place of the surface.

#include <algorithm>
#include <cmath>

#include "numeric/cauchy/traction_density.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
const TractionIntegrals<R>& RiemannHilbertSolution<R>::integrals() const {
  return integrals_([this] {
    std::vector<typename TractionIntegrals<R>::OnPanel> on_panels;
    auto load = loads().begin();
    for (std::size_t k = 0; k < contact_set().segments(); ++k) {
      if (!contact_set().in_contact(k)) continue;
      R error = 0;
      for (const JacobiPanel<R>& panel : form_.error_panels(whole_segment(contact_set(), k))) {
        using std::abs;
        const Estimate<R> t = traction(panel.node(contact_set(), 0));
        if (t.value != 0) error = std::max(error, R(t.error / abs(t.value)));
      }
      on_panels.push_back(
          {*load++, error, reduced_.s(form_.friction_at(k)), problem_.shear_ratio(form_.friction_at(k))});
    }
    return TractionIntegrals<R>(traction_density(form_), std::move(on_panels),
                                to_real<R>(problem_.elasticity().gamma()), *this, to_real<R>(reduced_.frame().unit));
  });
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::height_beyond(const SurfacePoint<R>& at) const {
  // From the support's end on, u'/c is the continued profile's slope less Y B, which has the power of an end of contact.
  using std::pow;
  const bool left = at.segment < 0;
  const std::size_t j = left ? 0 : contact_set().segments();
  const Side side = left ? Side::left : Side::right;
  const R& distance = left ? at.node.from_right : at.node.from_left;
  const Power<R> none{R(0), R(1)};
  const Power<R> power = contact_set().point(j).is_end() ? form_.power(j) : none;
  Estimate<R> integral =
      tanh_sinh::panel_integral<R>({{R(0), distance, distance}, power, none, [&](const Node<R>& node) {
                                      // Nothing is closer to the end, and double has no larger powers.
                                      const R d = std::max(node.from_left, reduced_.shortest_gap());
                                      const SurfacePoint<R> there = beside(contact_set(), j, side, d);
                                      const R y_b = (form_.profile_slope(there) - form_.surface_slope(there)).value;
                                      return R(y_b / pow(d, power.value));
                                    }});
  // What the slope may be off by, added up over parts of a quarter of their distance from the end.
  R error = 0;
  for (R d = distance; d > 0; d /= 4) {
    const SurfacePoint<R> there = beside(contact_set(), j, side, d);
    const R part = d * sample(there).slope.left.error / to_real<R>(problem_.elasticity().compliance());
    const bool last = d < contact_set().length(left ? 0 : j - 1);
    error += last ? part / (1 + power.value) : part;
    if (last) break;
  }
  integral.error += error;
  return left ? integral : -integral;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::height(const SurfacePoint<R>& at, std::optional<Estimate<R>> gap_there) const {
  using std::abs;
  const ContactSet<R>& set = contact_set();
  const auto last = static_cast<std::ptrdiff_t>(set.segments()) - 1;
  const auto segment = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at.segment, 0, last));
  const R unit = to_real<R>(reduced_.frame().unit);
  const R scale = to_real<R>(problem_.elasticity().compliance()) * unit;
  // The profile from the anchor on the left, exact there.
  const std::size_t anchor = set.interval(segment);
  const Rational& place = reduced_.place(anchor);
  const R from = to_real<R>(problem_.indenter().profile(place, Side::right)(place));
  const std::size_t k = form_.slope_at(segment);
  const R& anchor_x = reduced_.anchors()[anchor].x;
  const R to_anchor = form_.distance(at, set.point_of(anchor));
  const R rise = scale * reduced_.profile_increment(k, anchor_x, to_anchor);
  const R slope_error = reduced_.slope_estimate(k, anchor_x).error + reduced_.slope_estimate(k, at.node.x).error;
  const R tilted = scale * form_.tilt() * at.node.x;
  const R turned = unit * tilt().value_or(Estimate<R>{}).error * abs(at.node.x);
  const Estimate<R> profile{from + rise + tilted, 8 * epsilon<R>() * (abs(from) + abs(rise) + abs(tilted)) + turned +
                                                      scale * slope_error * abs(to_anchor)};
  if (at.segment == static_cast<std::ptrdiff_t>(segment)) return profile - (gap_there ? *gap_there : gap(at));
  const bool left = at.segment < 0;
  const std::size_t end = left ? 0 : set.segments();
  return profile - gap(beside(set, end, left ? Side::right : Side::left, R(0))) + scale * height_beyond(at);
}

template <Real R>
LinePlace<R> RiemannHilbertSolution<R>::line_place(const SurfacePoint<R>& at, std::optional<std::size_t> point) const {
  const ContactSet<R>& set = contact_set();
  LinePlace<R> place{0, infinity<R>(), infinity<R>()};
  std::size_t end = 0;  // of the last segment in contact on the left
  for (std::size_t k = 0; k < set.segments(); ++k) {
    if (!set.in_contact(k)) continue;
    const auto segment = static_cast<std::ptrdiff_t>(k);
    if (point ? k < *point : segment < at.segment) {
      ++place.panels;
      end = k + 1;
    } else if (segment == at.segment && !point) {
      place.inside = at.node;
    } else {
      place.to_right = point == k ? R(0) : -form_.distance(at, k);
      break;
    }
  }
  if (end > 0) place.to_left = point == end ? R(0) : form_.distance(at, end);
  return place;
}

template <Real R>
DetailedSample<R> RiemannHilbertSolution<R>::detailed(const SurfacePoint<R>& at) const {
  using std::abs;
  const ContactSet<R>& set = contact_set();
  const std::size_t last = set.segments() - 1;
  const std::optional<std::size_t> point = point_at(at);
  DetailedSample<R> result{point ? sample_at_point(*point) : sample(at), {}, {}, {}, {}};
  const auto height_there = [this](const SurfacePoint<R>& place, std::optional<std::size_t> j,
                                   std::optional<Estimate<R>> gap_there) {
    if (!j) return height(place, gap_there);
    const bool on_left = *j == contact_set().segments() || in_contact_at(*j, Side::left);
    return height(beside(contact_set(), *j, on_left ? Side::left : Side::right, R(0)));
  };
  result.displacement = height_there(at, point, result.gap) - height_at_origin_([&] {
                          const SurfacePoint<R> origin = locate(problem_.origin_of_displacement());
                          return height_there(origin, point_at(origin), std::nullopt);
                        });
  if (point) {
    result.friction = {form_.friction_at(*point > 0 ? *point - 1 : 0), form_.friction_at(std::min(*point, last))};
  } else if (at.segment >= 0 && at.segment <= static_cast<std::ptrdiff_t>(last)) {
    const std::size_t piece = form_.friction_at(static_cast<std::size_t>(at.segment));
    result.friction = {piece, piece};
  }

  const LinePlace<R> place = line_place(at, point);
  const R unit = to_real<R>(reduced_.frame().unit);
  const R c = to_real<R>(problem_.elasticity().compliance());
  result.cumulative_load = unit * integrals().load_before(place);
  const TwoSided<R> slope{result.slope.left / c, result.slope.right / c};
  if (point) {
    result.shear_slope = integrals().shear_slope(place, result.traction, slope);
  } else {
    result.cumulative_load.error += 2 * unit * end_error() * abs(result.traction.left.value);
    const Estimate<R> there = integrals().shear_slope(place, result.traction.left, slope.left);
    result.shear_slope = {there, there};
  }
  result.shear_slope.left *= c;
  result.shear_slope.right *= c;
  return result;
}

template <Real R>
DetailedSample<R> RiemannHilbertSolution<R>::details_at(const Rational& x) const {
  DetailedSample<R> result = detailed(locate(x));
  result.x = to_real<R>(x);
  return result;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::tangential_slope(const Rational& x) const {
  const SurfacePoint<R> at = locate(x);
  const R c = to_real<R>(problem_.elasticity().compliance());
  return c * integrals().shear_slope(line_place(at, std::nullopt), form_.traction(at), form_.surface_slope(at));
}

template <Real R>
std::vector<DetailedSample<R>> RiemannHilbertSolution<R>::detailed_samples(int count) const {
  std::vector<DetailedSample<R>> result;
  for (const SurfacePoint<R>& at : sampled_places(count)) result.push_back(detailed(at));
  return result;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                     \
  template const TractionIntegrals<R>& RiemannHilbertSolution<R>::integrals() const;                   \
  template Estimate<R> RiemannHilbertSolution<R>::height_beyond(const SurfacePoint<R>& at) const;      \
  template Estimate<R> RiemannHilbertSolution<R>::height(const SurfacePoint<R>& at,                    \
                                                         std::optional<Estimate<R>> gap_there) const;  \
  template LinePlace<R> RiemannHilbertSolution<R>::line_place(const SurfacePoint<R>& at,               \
                                                              std::optional<std::size_t> point) const; \
  template DetailedSample<R> RiemannHilbertSolution<R>::detailed(const SurfacePoint<R>& at) const;     \
  template DetailedSample<R> RiemannHilbertSolution<R>::details_at(const Rational& x) const;           \
  template Estimate<R> RiemannHilbertSolution<R>::tangential_slope(const Rational& x) const;           \
  template std::vector<DetailedSample<R>> RiemannHilbertSolution<R>::detailed_samples(int count) const;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
