// The solution at places of the surface, and its traction panel by panel.

#include <algorithm>
#include <cmath>

#include "numeric/cauchy/panel_finder.hpp"
#include "numeric/number/mapped.hpp"
#include "numeric/number/polynomial.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/riemann_hilbert/traction_density.hpp"

namespace steadyslide::numeric {

// Values at places of the surface.

template <Real R>
R RiemannHilbertSolution<R>::shear_ratio(std::size_t segment) const {
  return to_real<R>(problem_.shear_ratio(form_.friction_at(segment)));
}

template <Real R>
std::optional<std::size_t> RiemannHilbertSolution<R>::nearest_end(const SurfacePoint<R>& at) const {
  const std::vector<std::size_t>& ends = contact_set().ends();
  const auto next = std::partition_point(ends.begin(), ends.end(),
                                         [&at](std::size_t j) { return static_cast<std::ptrdiff_t>(j) <= at.segment; });
  std::optional<std::size_t> left, right;
  if (next != ends.begin()) left = *(next - 1);
  if (next != ends.end()) right = *next;
  if (!left || !right) return left ? left : right;
  return form_.distance(at, *left) <= -form_.distance(at, *right) ? left : right;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::gap(const SurfacePoint<R>& at) const {
  if (contact_set().in_contact(static_cast<std::size_t>(at.segment))) return {};
  const std::optional<std::size_t> end = nearest_end(at);
  if (!end) return {};
  const Estimate<R> reduced_gap = [&] {
    const std::lock_guard lock(measuring_);
    return gaps_.try_emplace(*end, form_, *end, found_.errors).first->second.reduced_gap(at);
  }();
  return R(compliance_ * unit_) * reduced_gap.widened(4 * epsilon<R>());
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::slope(const SurfacePoint<R>& at) const {
  Estimate<R> slope = form_.surface_slope(at);
  if (!in_contact(contact_set(), at)) {
    // The slope is the profile's slope minus a singular part. Only the singular part changes with the ends.
    slope.error += 2 * form_.modulus(at) * form_.error_of_state(at, found_.errors);
  }
  slope *= compliance_;
  if (const auto turned = tilt()) slope.error += turned->error;
  return slope;
}

template <Real R>
Sample<R> RiemannHilbertSolution<R>::sample(const SurfacePoint<R>& at) const {
  Sample<R> result;
  result.x = to_real<R>(reduced_.frame().origin) + unit_ * at.node.x;
  if (in_support(contact_set(), at)) result.gap = gap(at);
  if (in_contact(contact_set(), at)) {
    const Estimate<R> t = traction(at);
    const Estimate<R> shear = shear_of(problem_, form_.friction_at(static_cast<std::size_t>(at.segment)), t);
    result.traction = {t, t};
    result.shear = {shear, shear};
  }
  const Estimate<R> here = slope(at);
  result.slope = {here, here};
  return result;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::traction_limit(std::size_t j, Side side) const {
  if (!in_contact_at(j, side)) return {};
  const Exponent& p = form_.power(j).value == 0 ? Exponent(0) : form_.exponent(j);
  if (p.sign() < 0) return {-infinity<R>(), R(0)};
  if (form_.changes_polynomial(j)) {
    if (p.sign() > 0) return constant(j);
    // If there is no corner (only the curvature changes), the factor of the logarithm is zero.
    const int corner = sign(contact_set().anchor_at(j)->exact.wedge);
    if (corner != 0) return {corner > 0 ? -infinity<R>() : infinity<R>(), R(0)};
  }
  if (p.sign() > 0) return {};
  return reduced_.cos_alpha(form_.friction_at(side == Side::left ? j - 1 : j)) * amplitude(j, side);
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::slope_limit(std::size_t j, Side side) const {
  const auto& point = contact_set().point(j);
  const bool contact = in_contact_at(j, side);
  if (!contact && point.is_end() && !point.vanishes) {
    return {side == Side::left ? -infinity<R>() : infinity<R>(), R(0)};
  }
  std::ptrdiff_t segment = static_cast<std::ptrdiff_t>(j) - (side == Side::left ? 1 : 0);
  if (contact || point.is_end()) {
    // At a free end the surface continues along the profile of the contact.
    if (!contact) segment += side == Side::left ? 1 : -1;
    const Estimate<R> slope =
        reduced_.slope_estimate(form_.slope_at(static_cast<std::size_t>(segment)), contact_set().x(j));
    return compliance_ * slope + tilt().value_or(Estimate<R>{compliance_ * form_.tilt(), R(0)});
  }
  // Outside the contact the surface is smooth, also where the profile is not.
  return slope(beside(contact_set(), j, side, R(0)));
}

template <Real R>
Sample<R> RiemannHilbertSolution<R>::sample_at_point(std::size_t j) const {
  Sample<R> result;
  result.x = coordinate(j).value;
  result.traction = {traction_limit(j, Side::left), traction_limit(j, Side::right)};
  result.shear = {
      j == 0 ? Estimate<R>{} : shear_of(problem_, form_.friction_at(j - 1), result.traction.left),
      j == contact_set().segments() ? Estimate<R>{} : shear_of(problem_, form_.friction_at(j), result.traction.right)};
  result.slope = {slope_limit(j, Side::left), slope_limit(j, Side::right)};
  if (in_contact_at(j, Side::left) || in_contact_at(j, Side::right)) {
    result.gap = Estimate<R>{};
  } else {
    // At the support's ends, take the only segment, which is inside; at a step, take the side of the lower gap.
    for (const Side side : {Side::left, Side::right}) {
      if (j == (side == Side::left ? 0 : contact_set().segments())) continue;
      const Estimate<R> here = gap(beside(contact_set(), j, side, R(0)));
      if (!result.gap || here.value < result.gap->value) result.gap = here;
    }
  }
  return result;
}

template <Real R>
SurfacePoint<R> RiemannHilbertSolution<R>::locate(const Rational& x) const {
  const Frame& frame = reduced_.frame();
  const R xi = to_real<R>((x - frame.origin) / frame.unit);
  const std::size_t last = reduced_.anchors().size() - 1;
  const auto from = [&](std::size_t anchor) { return to_real<R>((x - reduced_.place(anchor)) / frame.unit); };
  const ContactSet<R>& set = contact_set();
  if (x < reduced_.place(0)) return {-1, {xi, infinity<R>(), -from(0)}};
  if (x > reduced_.place(last)) return {static_cast<std::ptrdiff_t>(set.segments()), {xi, from(last), infinity<R>()}};

  std::size_t interval = 0;
  while (interval + 1 < last && x > reduced_.place(interval + 1)) ++interval;
  const std::size_t first = set.point_of(interval);
  const std::size_t end = set.point_of(interval + 1);
  // Distances from the points of the interval are computed from the nearer anchor; by coordinates if both are far.
  const R left = from(interval);
  const R right = -from(interval + 1);
  const bool left_is_near = left < right;
  const auto to_point = [&](std::size_t j) {
    if (!set.point(j).anchor && left > 4 && right > 4) return set.x(j) - xi;
    R d = left_is_near ? left : right;
    if (left_is_near) {
      for (std::size_t k = first; k < j; ++k) d -= set.length(k);
      return -d;
    }
    for (std::size_t k = j; k < end; ++k) d -= set.length(k);
    return d;
  };
  std::size_t segment = first;
  while (segment + 1 < end && to_point(segment + 1) < 0) ++segment;
  return {static_cast<std::ptrdiff_t>(segment), {xi, -to_point(segment), to_point(segment + 1)}};
}

template <Real R>
std::optional<std::size_t> RiemannHilbertSolution<R>::point_at(const SurfacePoint<R>& at) const {
  if (!in_support(contact_set(), at)) return std::nullopt;
  if (at.node.from_left <= 0) return static_cast<std::size_t>(at.segment);
  if (at.node.from_right <= 0) return static_cast<std::size_t>(at.segment + 1);
  return std::nullopt;
}

template <Real R>
Sample<R> RiemannHilbertSolution<R>::at(const Rational& x) const {
  const SurfacePoint<R> place = locate(x);
  const std::optional<std::size_t> point = point_at(place);
  Sample<R> result = point ? sample_at_point(*point) : sample(place);
  result.x = to_real<R>(x);
  return result;
}

/// Returns the set's points in the user's x. A point that is not an anchor is placed by lengths from the nearer anchor.
template <Real R>
std::vector<Rational> RiemannHilbertSolution<R>::places() const {
  const ContactSet<R>& set = contact_set();
  const std::size_t last = set.segments();
  std::vector<Rational> result(last + 1), from_left(last + 1);
  for (std::size_t j = 0; j <= last; ++j) {
    const auto& anchor = set.point(j).anchor;
    if (!anchor) from_left[j] = from_left[j - 1] + Rational(set.length(j - 1));
    result[j] = anchor ? reduced_.place(*anchor)
                       : Rational(result[j - 1] + reduced_.frame().unit * Rational(set.length(j - 1)));
  }
  Rational from_right = 0;
  for (std::size_t j = last; j-- > 0;) {
    if (set.point(j).anchor) {
      from_right = 0;
      continue;
    }
    from_right += Rational(set.length(j));
    if (from_right < from_left[j]) result[j] = result[j + 1] - reduced_.frame().unit * Rational(set.length(j));
  }
  return result;
}

template <Real R>
void RiemannHilbertSolution<R>::tractions(std::span<const R> x, std::span<R> normal, std::span<R> shear) const {
  std::fill(normal.begin(), normal.end(), R(0));
  std::fill(shear.begin(), shear.end(), R(0));
  const ContactSet<R>& set = contact_set();
  PanelFinder<R>(places(), reduced_.frame().unit)
      .visit(
          x,
          [&](std::size_t segment, std::size_t first, std::span<const R> from_left, std::span<const R> from_right) {
            if (!set.in_contact(segment)) return;
            const std::span<R> values = normal.subspan(first, from_left.size());
            form_.tractions(segment, from_left, from_right, values);
            const R ratio = shear_ratio(segment);
            for (std::size_t i = 0; i < values.size(); ++i) shear[first + i] = ratio * values[i];
          },
          [&](std::size_t i) {
            ContactSolution<R>::tractions(x.subspan(i, 1), normal.subspan(i, 1), shear.subspan(i, 1));
          });
}

template <Real R>
std::vector<SurfacePoint<R>> RiemannHilbertSolution<R>::sampled_places(int count) const {
  std::vector<SurfacePoint<R>> result;
  const ContactSet<R>& set = contact_set();
  for (const auto& [first, end] : set.runs()) {
    R width = 0;
    for (std::size_t k = first; k < end; ++k) width += set.length(k);
    // The points are distributed over the segments: one half equally, the other half in proportion to the length.
    R before = 0;
    int done = 0;
    for (std::size_t k = first; k < end; ++k) {
      before += set.length(k);
      const R part = R(static_cast<double>(k + 1 - first)) / static_cast<double>(end - first);
      const int until = k + 1 == end ? count : static_cast<int>(count * (part + before / width) / 2);
      const int n = until - done;
      for (int i = 0; i < n; ++i) {
        const auto [left, right] = chebyshev_position<R>(i, n);
        result.push_back(surface_point(set, k, left * set.length(k), right * set.length(k)));
      }
      done = until;
    }
  }
  return result;
}

template <Real R>
std::vector<Sample<R>> RiemannHilbertSolution<R>::samples(int count) const {
  return mapped(sampled_places(count), [this](const SurfacePoint<R>& at) { return sample(at); });
}

// Integrals of the traction add these terms at a place.

template <Real R>
const TractionIntegrals<R>& RiemannHilbertSolution<R>::integrals() const {
  return integrals_([this] {
    std::vector<typename TractionIntegrals<R>::OnPanel> on_panels;
    auto load = loads().begin();
    for (const std::size_t k : contact_set().contact_segments()) {
      R error = 0;
      for (const JacobiPanel<R>& panel : form_.error_panels(whole_segment(contact_set(), k))) {
        const Estimate<R> t = traction(panel.node(contact_set(), 0));
        if (t.value != 0) error = std::max(error, R(t.error / abs(t.value)));
      }
      const auto error_at = [&](std::size_t j, Side side) {
        return traction(beside(contact_set(), j, side, R(epsilon<R>() * contact_set().length(k)))).error;
      };
      on_panels.push_back({*load++, error, error_at(k, Side::right), error_at(k + 1, Side::left),
                           reduced_.s(form_.friction_at(k)), problem_.shear_ratio(form_.friction_at(k))});
    }
    return TractionIntegrals<R>(traction_density(form_), std::move(on_panels),
                                to_real<R>(problem_.elasticity().gamma()), *this, unit_);
  });
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::height_beyond(const SurfacePoint<R>& at) const {
  // Beyond the support's end, u'/c is the continued profile's slope minus Y B, which has the power of an end of
  // contact.
  const bool left = at.segment < 0;
  const std::size_t j = left ? 0 : contact_set().segments();
  const Side side = left ? Side::left : Side::right;
  const R& distance = left ? at.node.from_right : at.node.from_left;
  const Power<R> power = contact_set().point(j).is_end() ? form_.power(j) : Power<R>{};
  Estimate<R> integral =
      tanh_sinh::panel_integral<R>({{R(0), distance, distance}, power, {}, [&](const Node<R>& node) {
                                      // No place is closer to the end, and double cannot represent larger powers.
                                      const R d = std::max(node.from_left, reduced_.shortest_gap());
                                      const SurfacePoint<R> there = beside(contact_set(), j, side, d);
                                      const R y_b = (form_.profile_slope(there) - form_.surface_slope(there)).value;
                                      return R(y_b / pow(d, power.value));
                                    }});
  // The error of the slope, summed over parts whose length is a quarter of their distance from the end.
  R error = 0;
  for (R d = distance; d > 0; d /= 4) {
    const SurfacePoint<R> there = beside(contact_set(), j, side, d);
    const R part = d * sample(there).slope.left.error / compliance_;
    const bool last = d < contact_set().length(left ? 0 : j - 1);
    error += last ? part / (1 + power.value) : part;
    if (last) break;
  }
  integral.error += error;
  return left ? integral : -integral;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::height(const SurfacePoint<R>& at, std::optional<Estimate<R>> gap_there) const {
  const ContactSet<R>& set = contact_set();
  const auto last = static_cast<std::ptrdiff_t>(set.segments()) - 1;
  const auto segment = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at.segment, 0, last));
  const R scale = compliance_ * unit_;
  // Measure the profile from the anchor on the left, where it is exact.
  const std::size_t anchor = set.interval(segment);
  const Rational& place = reduced_.place(anchor);
  const R from = to_real<R>(problem_.indenter().profile(place, Side::right)(place));
  const std::size_t k = form_.slope_at(segment);
  const R& anchor_x = reduced_.anchors()[anchor].x;
  const R to_anchor = form_.distance(at, set.point_of(anchor));
  const R rise = scale * reduced_.profile_increment(k, anchor_x, to_anchor);
  const R slope_error = reduced_.slope_estimate(k, anchor_x).error + reduced_.slope_estimate(k, at.node.x).error;
  const R tilted = scale * form_.tilt() * at.node.x;
  const R turned = unit_ * tilt().value_or(Estimate<R>{}).error * abs(at.node.x);
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
  std::size_t end = 0;  // the end of the last segment in contact on the left
  for (const std::size_t k : set.contact_segments()) {
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

  integrals().add_to(result, line_place(at, point), point.has_value(), compliance_, end_error());
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
  return compliance_ *
         integrals().shear_slope(line_place(at, std::nullopt), form_.traction(at), form_.surface_slope(at));
}

template <Real R>
std::vector<DetailedSample<R>> RiemannHilbertSolution<R>::detailed_samples(int count) const {
  return mapped(sampled_places(count), [this](const SurfacePoint<R>& at) { return detailed(at); });
}

// The traction as panels with a power and a polynomial.

template <Real R>
std::function<R(const R&)> RiemannHilbertSolution<R>::corner(std::size_t j, Side side) const {
  if (!form_.changes_polynomial(j)) return nullptr;
  const Rational& x = reduced_.place(*contact_set().point(j).anchor);
  const Indenter& indenter = problem_.indenter();
  const Rational s = problem_.coupled_friction(form_.friction_at(j - 1));
  Rational divisor = problem_.elasticity().compliance() * (problem_.coupled_friction(form_.friction_at(j)) - s);
  R factor = 1;
  if (form_.power(j).value == 0) {
    divisor = problem_.elasticity().compliance() * (1 + s * s);
    factor = 1 / pi<R>();
  }
  // D in powers of d, exact.
  const Polynomial jump = (indenter.profile(x, Side::right) - indenter.profile(x, Side::left)).derivative();
  const Polynomial beside = jump.composed(side == Side::left ? -1 : 1, x);
  const auto coefficients =
      mapped(beside.coefficients(), [&](const Rational& a) { return R(factor * to_real<R>(a / divisor)); });
  return [coefficients](const R& d) { return value_of(coefficients, d); };
}

template <Real R>
PiecewiseTraction<R> RiemannHilbertSolution<R>::piecewise_traction() const {
  const ContactSet<R>& set = contact_set();
  const std::vector<Rational> points = places();
  const auto is_singular = [&](std::size_t j) { return form_.power(j).value != 0 || form_.changes_polynomial(j); };
  const auto displaced = [&](std::size_t j) { return set.point(j).is_movable() ? R(unit_ * end_error()) : R(0); };
  PiecewiseTraction<R> result(problem_.elasticity(), reduced_.highest_degree());
  for (const std::size_t k : set.contact_segments()) {
    Surroundings<R> around = surroundings<R>(set, k, is_singular);
    around.beyond_left *= unit_;
    around.beyond_right *= unit_;
    result.add({SurfacePlace<R>::of(points[k]), SurfacePlace<R>::of(points[k + 1]), R(unit_ * set.length(k)), around,
                form_.power(k), form_.power(k + 1), corner(k, Side::right), corner(k + 1, Side::left), shear_ratio(k),
                [&, k](std::span<const R> from_left, std::span<const R> from_right, std::span<R> values) {
                  std::vector<R> left(from_left.begin(), from_left.end());
                  std::vector<R> right(from_right.begin(), from_right.end());
                  for (std::vector<R>* distances : {&left, &right}) {
                    for (R& d : *distances) d /= unit_;
                  }
                  form_.tractions(k, left, right, values);
                },
                [&, k](const R& from_left, const R& from_right) {
                  const SurfacePoint<R> at = surface_point(set, k, R(from_left / unit_), R(from_right / unit_));
                  const Estimate<R> t = traction(at);
                  // The position of x relative to the free ends has their error: count it twice.
                  return R(16 * epsilon<R>() + 2 * relative_end_error(at) +
                           (t.value == 0 ? R(0) : R(t.error / abs(t.value))));
                },
                displaced(k), displaced(k + 1)});
  }
  return result;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                                  \
  template R RiemannHilbertSolution<R>::shear_ratio(std::size_t segment) const;                                     \
  template std::optional<std::size_t> RiemannHilbertSolution<R>::nearest_end(const SurfacePoint<R>& at) const;      \
  template Estimate<R> RiemannHilbertSolution<R>::traction_limit(std::size_t j, Side side) const;                   \
  template SurfacePoint<R> RiemannHilbertSolution<R>::locate(const Rational& x) const;                              \
  template Sample<R> RiemannHilbertSolution<R>::at(const Rational& x) const;                                        \
  template void RiemannHilbertSolution<R>::tractions(std::span<const R> x, std::span<R> normal, std::span<R> shear) \
      const;                                                                                                        \
  template std::vector<Sample<R>> RiemannHilbertSolution<R>::samples(int count) const;                              \
  template DetailedSample<R> RiemannHilbertSolution<R>::details_at(const Rational& x) const;                        \
  template Estimate<R> RiemannHilbertSolution<R>::tangential_slope(const Rational& x) const;                        \
  template std::vector<DetailedSample<R>> RiemannHilbertSolution<R>::detailed_samples(int count) const;             \
  template PiecewiseTraction<R> RiemannHilbertSolution<R>::piecewise_traction() const;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
