// The solution at places of the surface.

#include <algorithm>
#include <cmath>

#include "numeric/cauchy/panel_finder.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"

namespace steadyslide::numeric {

template <Real R>
R RiemannHilbertSolution<R>::shear_ratio(std::size_t segment) const {
  return to_real<R>(problem_.shear_ratio(form_.friction_at(segment)));
}

template <Real R>
std::optional<std::size_t> RiemannHilbertSolution<R>::nearest_end(const SurfacePoint<R>& at) const {
  std::optional<std::size_t> left, right;
  const std::size_t points = contact_set().points().size();
  for (std::size_t j = 0; j < points; ++j) {
    if (!contact_set().point(j).is_end()) continue;
    if (static_cast<std::ptrdiff_t>(j) <= at.segment) left = j;
    if (static_cast<std::ptrdiff_t>(j) > at.segment && !right) right = j;
  }
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
  const R scale = to_real<R>(problem_.elasticity().compliance()) * to_real<R>(reduced_.frame().unit);
  return scale * reduced_gap.widened(4 * epsilon<R>());
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::slope(const SurfacePoint<R>& at) const {
  const R c = to_real<R>(problem_.elasticity().compliance());
  Estimate<R> slope = form_.surface_slope(at);
  const bool in_support = at.segment >= 0 && at.segment < static_cast<std::ptrdiff_t>(contact_set().segments());
  if (!in_support || !contact_set().in_contact(static_cast<std::size_t>(at.segment))) {
    // The slope is the profile's less a singular part: that is what ends move.
    slope.error += 2 * form_.modulus(at) * form_.error_of_state(at, found_.errors);
  }
  slope *= c;
  if (const auto turned = tilt()) slope.error += turned->error;
  return slope;
}

template <Real R>
Sample<R> RiemannHilbertSolution<R>::sample(const SurfacePoint<R>& at) const {
  Sample<R> result;
  result.x = to_real<R>(reduced_.frame().origin) + to_real<R>(reduced_.frame().unit) * at.node.x;
  const bool in_support = at.segment >= 0 && at.segment < static_cast<std::ptrdiff_t>(contact_set().segments());
  if (in_support) result.gap = gap(at);
  if (in_support && contact_set().in_contact(static_cast<std::size_t>(at.segment))) {
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
    // Without a corner (only the curvature changes) the logarithm is multiplied by zero.
    if (const int corner = sign(wedge(j)); corner != 0) return {corner > 0 ? -infinity<R>() : infinity<R>(), R(0)};
  }
  if (p.sign() > 0) return {};
  return reduced_.cos_alpha(form_.friction_at(side == Side::left ? j - 1 : j)) * amplitude(j, side);
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::slope_limit(std::size_t j, Side side) const {
  const R c = to_real<R>(problem_.elasticity().compliance());
  const auto& point = contact_set().point(j);
  const bool contact = in_contact_at(j, side);
  if (!contact && point.is_end() && !point.vanishes) {
    return {side == Side::left ? -infinity<R>() : infinity<R>(), R(0)};
  }
  std::ptrdiff_t segment = static_cast<std::ptrdiff_t>(j) - (side == Side::left ? 1 : 0);
  if (contact || point.is_end()) {
    // The surface leaves a free end along the profile of the contact.
    if (!contact) segment += side == Side::left ? 1 : -1;
    const Estimate<R> slope =
        reduced_.slope_estimate(form_.slope_at(static_cast<std::size_t>(segment)), contact_set().x(j));
    return c * slope + tilt().value_or(Estimate<R>{c * form_.tilt(), R(0)});
  }
  // Off the contact the surface is smooth, whatever the profile does above it.
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
    // At the support's ends the only segment is the inner one; at a step, the side of the lower gap.
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
  // Distances from the points of the interval, by way of the anchor that is nearer; by coordinates if both are far.
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
  if (at.segment < 0 || at.segment >= static_cast<std::ptrdiff_t>(contact_set().segments())) return std::nullopt;
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

/// The set's points in the user's x; what is no anchor lies beside the nearer one, by lengths.
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
    // Each segment gets its part of the count, half of it by number and half by length.
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
  std::vector<Sample<R>> result;
  for (const SurfacePoint<R>& at : sampled_places(count)) result.push_back(sample(at));
  return result;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                                  \
  template std::vector<Rational> RiemannHilbertSolution<R>::places() const;                                         \
  template R RiemannHilbertSolution<R>::shear_ratio(std::size_t segment) const;                                     \
  template std::optional<std::size_t> RiemannHilbertSolution<R>::nearest_end(const SurfacePoint<R>& at) const;      \
  template Estimate<R> RiemannHilbertSolution<R>::gap(const SurfacePoint<R>& at) const;                             \
  template Estimate<R> RiemannHilbertSolution<R>::slope(const SurfacePoint<R>& at) const;                           \
  template Sample<R> RiemannHilbertSolution<R>::sample(const SurfacePoint<R>& at) const;                            \
  template Estimate<R> RiemannHilbertSolution<R>::traction_limit(std::size_t j, Side side) const;                   \
  template Estimate<R> RiemannHilbertSolution<R>::slope_limit(std::size_t j, Side side) const;                      \
  template Sample<R> RiemannHilbertSolution<R>::sample_at_point(std::size_t j) const;                               \
  template SurfacePoint<R> RiemannHilbertSolution<R>::locate(const Rational& x) const;                              \
  template std::optional<std::size_t> RiemannHilbertSolution<R>::point_at(const SurfacePoint<R>& at) const;         \
  template Sample<R> RiemannHilbertSolution<R>::at(const Rational& x) const;                                        \
  template void RiemannHilbertSolution<R>::tractions(std::span<const R> x, std::span<R> normal, std::span<R> shear) \
      const;                                                                                                        \
  template std::vector<SurfacePoint<R>> RiemannHilbertSolution<R>::sampled_places(int count) const;                 \
  template std::vector<Sample<R>> RiemannHilbertSolution<R>::samples(int count) const;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
