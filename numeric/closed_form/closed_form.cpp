#include "numeric/closed_form/closed_form.hpp"

#include <algorithm>
#include <bit>

#include "numeric/cauchy/panel_finder.hpp"
#include "numeric/number/mapped.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/solution/largest_pressure.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
TwoSided<R> both(const Estimate<R>& value) {
  return {value, value};
}

}  // namespace

template <Real R>
ClosedForm<R>::ClosedForm(ContactProblem problem, ClosedFormData<R> data)
    : problem_(std::move(problem)),
      compliance_(to_real<R>(problem_.elasticity().compliance())),
      data_(std::move(data)) {}

template <Real R>
Estimate<R> ClosedForm<R>::coordinate(std::size_t j) const {
  if (data_.exact[j]) {
    const R x = to_real<R>(data_.origin + *data_.exact[j]);
    return {x, epsilon<R>() * abs(x)};
  }
  const R x = to_real<R>(data_.origin) + weight().point(j);
  return {x, data_.end_error + epsilon<R>() * (abs(x) + abs(weight().point(j)))};
}

template <Real R>
std::vector<Rational> ClosedForm<R>::points() const {
  std::vector<Rational> result;
  for (std::size_t j = 0; j < data_.exact.size(); ++j) {
    result.push_back(data_.origin + data_.exact[j].value_or(Rational(weight().point(j))));
  }
  return result;
}

/// Returns the relative error of |Y| in the middle of a panel, with the error of the ends counted `times` times.
template <Real R>
R ClosedForm<R>::relative_error(std::size_t panel, int times) const {
  const Panel<R>& p = weight().panel(panel);
  return weight().relative_error(panel, p.node_from_left(p.length / 2), times * data_.end_error);
}

template <Real R>
Estimate<R> ClosedForm<R>::intensity(std::size_t j) const {
  const std::size_t last = weight().panel_count();
  R theta = abs(data_.factor) * weight().amplitude(j);
  // At an end theta contains cos(pi alpha) of the contact side; at a jump its definition does not contain it.
  if (j == 0) theta = abs(data_.traction.amplitudes.front()) * weight().amplitude(j);
  if (j == last) theta = abs(data_.traction.amplitudes.back()) * weight().amplitude(j);
  return {theta, theta * relative_error(std::min(j, last - 1), 4)};
}

template <Real R>
std::vector<ContactComponent<R>> ClosedForm<R>::contact() const {
  const std::size_t last = weight().panel_count();
  const R width = weight().point(last) - weight().point(0);
  return {{{coordinate(0), data_.ends, data_.exponents.front(), intensity(0)},
           {coordinate(last), data_.ends, data_.exponents.back(), intensity(last)},
           {width, 2 * data_.end_error + 4 * epsilon<R>() * width}}};
}

template <Real R>
ApproximateContact ClosedForm<R>::approximate_contact() const {
  if (data_.ends == SingularKind::edge) return {{{problem_.indenter().left()}, {problem_.indenter().right()}}};
  const auto end = [&](std::size_t j) { return ApproximateContact::free_end(problem_, Rational(coordinate(j).value)); };
  return {{end(0), end(weight().panel_count())}};
}

template <Real R>
std::vector<SolvedSingularPoint<R>> ClosedForm<R>::singular_points() const {
  std::vector<SolvedSingularPoint<R>> points;
  const std::size_t last = weight().panel_count();
  for (std::size_t j = 0; j <= last; ++j) {
    const bool is_end = j == 0 || j == last;
    if (!is_end && data_.exponents[j].sign() == 0) continue;
    const Estimate<R> theta = intensity(j);
    const auto on_side = [&](std::size_t piece) {
      const R factor = is_end ? R(1) : cos_pi_alpha<R>(problem_.coupled_friction(data_.first_piece + piece));
      return stress_intensity_of<R>(factor * theta, weight().powers()[j].value);
    };
    StressIntensity<R> k;
    if (j > 0) k.left = on_side(j - 1);
    if (j < last) k.right = on_side(j);
    points.push_back({coordinate(j), is_end ? data_.ends : SingularKind::friction_jump, data_.exponents[j], theta,
                      Estimate<R>{}, k});
  }
  return points;
}

template <Real R>
const SurfaceCheck<R>& ClosedForm<R>::check() const {
  return check_([this] {
    std::vector<R> s;
    for (std::size_t k = 0; k < weight().panel_count(); ++k) {
      s.push_back(to_real<R>(problem_.coupled_friction(data_.first_piece + k)));
    }
    return SurfaceCheck<R>(data_.traction.density(), std::move(s),
                           [this](std::size_t, const Node<R>& node) { return profile_slope(node.x); });
  });
}

template <Real R>
Resultants<R> ClosedForm<R>::resultants() const {
  return resultants_([this] {
    std::vector<Estimate<R>> on_pieces(problem_.friction().values().size());
    for (std::size_t k = 0; k < loads().size(); ++k) on_pieces[data_.first_piece + k] = -loads()[k];
    Resultants<R> result = resultants_of(on_pieces, problem_.friction().values());
    result.component_load = {result.normal};

    // The moments of t are coefficients of u' at infinity, which are power sums of the singular points.
    R sum1 = 0, sum2 = 0, sum3 = 0, size = 0;
    for (std::size_t j = 0; j < data_.exponents.size(); ++j) {
      const R& p = weight().powers()[j].value;
      const R x = weight().point(j);
      sum1 += p * x;
      sum2 += p * x * x;
      sum3 += p * x * x * x;
      size = std::max(size, abs(x));
    }
    const R offset = data_.ends == SingularKind::edge ? -sum1 : 2 * sum3 / (3 * sum2);
    const R points = R(static_cast<double>(data_.exponents.size()));
    result.centre_of_pressure = {
        to_real<R>(data_.origin) + offset,
        8 * points * (epsilon<R>() * size + data_.end_error) + epsilon<R>() * abs(to_real<R>(data_.origin))};
    return result;
  });
}

template <Real R>
const std::vector<Estimate<R>>& ClosedForm<R>::loads() const {
  return loads_([this] {
    const PiecewiseDensity<R> density = data_.traction.density();
    std::vector<Estimate<R>> result;
    for (std::size_t k = 0; k < density.size(); ++k) {
      std::optional<Estimate<R>> load;
      if constexpr (!std::same_as<R, double>) load = check().panel_integral(k);
      if (!load) load = tanh_sinh::panel_integral(density[k]);
      result.push_back(load->widened(relative_error(k, 8)));
    }
    return result;
  });
}

template <Real R>
LargestPressure<R> ClosedForm<R>::largest_pressure() const {
  if (const auto infinite = infinite_pressure(singular_points())) return *infinite;
  std::vector<R> lengths;
  for (std::size_t k = 0; k < weight().panel_count(); ++k) lengths.push_back(weight().panel(k).length);
  // The pressure is 0 at free ends, and at jumps where friction decreases.
  const PanelFunction<R> pressure = [this](std::size_t k, const R& left, const R& right) {
    const Node<R> node{weight().panel(k).left + left, left, right};
    return Estimate<R>{-traction(k, node), R(0)}.widened(weight().relative_error(k, node, data_.end_error));
  };
  return finite_pressure<R>({}, lengths, pressure, [&](const Peak<R>& peak) -> Estimate<R> {
    const R x = to_real<R>(data_.origin) + weight().panel(peak.panel).left + peak.from_left;
    return {x, peak.place_error + data_.end_error + 2 * epsilon<R>() * abs(x)};
  });
}

template <Real R>
EstimatedError<R> ClosedForm<R>::estimated_error() const {
  EstimatedError<R> worst{0, 0, 0};
  const R width = weight().point(weight().panel_count()) - weight().point(0);
  worst.ends = max(data_.end_error / width, epsilon<R>());
  for (std::size_t k = 0; k < weight().panel_count(); ++k) {
    worst.traction = max(worst.traction, relative_error(k, 1));
  }
  const Resultants<R> r = resultants();
  worst.resultants = r.normal.error / r.normal.value;
  return worst;
}

template <Real R>
R ClosedForm<R>::profile_slope(const R& from_origin) const {
  return data_.ends == SingularKind::edge ? R(0) : data_.factor * from_origin;
}

template <Real R>
Estimate<R> ClosedForm<R>::slope_in_contact(const R& from_origin) const {
  const R slope = compliance_ * profile_slope(from_origin);
  // A place is a sum of lengths from the left end; rounding shifts it.
  const R shift = 2 * epsilon<R>() * max(abs(weight().point(0)), abs(weight().point(weight().panel_count())));
  return {slope, 4 * epsilon<R>() * abs(slope) + compliance_ * abs(profile_slope(shift))};
}

template <Real R>
R ClosedForm<R>::gap_length(Side side) const {
  if (data_.ends == SingularKind::edge) return 0;
  const Indenter& indenter = problem_.indenter();
  const R length = side == Side::left
                       ? weight().point(0) - to_real<R>(indenter.left() - data_.origin)
                       : to_real<R>(indenter.right() - data_.origin) - weight().point(weight().panel_count());
  return std::max(length, R(0));
}

template <Real R>
Residuals<R> ClosedForm<R>::residuals() const {
  const R load = to_real<R>(problem_.load());
  const R width = weight().point(weight().panel_count()) - weight().point(0);
  Residuals<R> result;
  result.equation = check().equation();
  result.load = abs(check().integral() + load) / load;
  R deepest = 0;
  for (const Side side : {Side::left, Side::right}) {
    const R length = gap_length(side);
    if (length == 0) continue;
    for (const R& part : gap_places<R>()) {
      const R distance = length * part;
      const std::size_t panel = side == Side::left ? 0 : weight().panel_count() - 1;
      const R end = weight().point(side == Side::left ? 0 : weight().panel_count());
      const R x = side == Side::left ? end - distance : end + distance;
      const R rise = distance * (side == Side::left ? R(-1) : R(1)) * (profile_slope(end) + profile_slope(x)) / 2;
      deepest = max(deepest, check().penetration(panel, side, distance, rise));
    }
  }
  // Both are reduced (divided by c): the penetration, and its bound c P / c.
  result.penetration = deepest / load;
  result.tension = max(check().highest_traction(), R(0)) * width / load;
  return result;
}

template <Real R>
PiecewiseTraction<R> ClosedForm<R>::piecewise_traction() const {
  const std::vector<Power<R>>& powers = weight().powers();
  const std::size_t panels = weight().panel_count();
  const std::vector<SurfacePlace<R>> places = mapped(points(), SurfacePlace<R>::of);
  const auto length = [&](std::size_t k) { return k < panels ? weight().panel(k).length : infinity<R>(); };
  PiecewiseTraction<R> result(problem_.elasticity());
  for (std::size_t k = 0; k < panels; ++k) {
    const Surroundings<R> around{powers[k].value != 0, powers[k + 1].value != 0, length(k == 0 ? panels : k - 1),
                                 length(k + 1)};
    result.add({places[k], places[k + 1], length(k), around, powers[k], powers[k + 1], nullptr, nullptr,
                to_real<R>(problem_.shear_ratio(data_.first_piece + k)),
                [&, k](std::span<const R> from_left, std::span<const R> from_right, std::span<R> values) {
                  data_.traction(k, from_left, from_right, values);
                },
                [&, k](const R& from_left, const R& from_right) {
                  const Node<R> node{weight().point(k) + from_left, from_left, from_right};
                  return R(16 * epsilon<R>() + weight().relative_error(k, node, 2 * data_.end_error));
                },
                k == 0 ? data_.end_error : R(0), k + 1 == panels ? data_.end_error : R(0)});
  }
  return result;
}

template <Real R>
const TractionIntegrals<R>& ClosedForm<R>::integrals() const {
  return integrals_([this] {
    std::vector<typename TractionIntegrals<R>::OnPanel> on_panels;
    for (std::size_t k = 0; k < weight().panel_count(); ++k) {
      // Sample at an eighth of a panel from its ends.
      R error = 0;
      for (const R& part : {R(0.125), R(0.875)}) {
        const Panel<R>& panel = weight().panel(k);
        error = std::max(error, weight().relative_error(k, panel.node_from_left(part * panel.length), data_.end_error));
      }
      on_panels.push_back({loads()[k], error, R(0), R(0), to_real<R>(problem_.coupled_friction(data_.first_piece + k)),
                           problem_.shear_ratio(data_.first_piece + k)});
    }
    return TractionIntegrals<R>(data_.traction.density(), std::move(on_panels),
                                to_real<R>(problem_.elasticity().gamma()), *this, R(1));
  });
}

// Values of the closed form at places of the surface.

template <Real R>
Sample<R> ClosedForm<R>::inside(std::size_t panel, const Node<R>& node, const R& traction) const {
  const Estimate<R> estimate =
      Estimate<R>{traction, R(0)}.widened(weight().relative_error(panel, node, data_.end_error));
  return {to_real<R>(data_.origin) + node.x, both(estimate),
          both(shear_of(problem_, data_.first_piece + panel, estimate)), Estimate<R>{}, both(slope_in_contact(node.x))};
}

template <Real R>
Estimate<R> ClosedForm<R>::limit_at_point(std::size_t j, Side side) const {
  if (side == Side::left ? j == 0 : j == weight().panel_count()) return {};  // no contact on that side
  const int sign = data_.exponents[j].sign();
  if (sign > 0) return {};
  if (sign < 0) return {-infinity<R>(), 0};
  const std::size_t panel = side == Side::left ? j - 1 : j;
  const R t = traction(panel, weight().panel(panel).node_from(opposite(side), R(0)));
  return Estimate<R>{t, R(0)}.widened(relative_error(panel, 4));
}

template <Real R>
Sample<R> ClosedForm<R>::at_point(std::size_t j) const {
  const std::size_t last = weight().panel_count();
  Sample<R> sample;
  sample.x = coordinate(j).value;
  sample.traction = {limit_at_point(j, Side::left), limit_at_point(j, Side::right)};
  const std::size_t right = data_.first_piece + j;
  sample.shear = {j == 0 ? Estimate<R>{} : shear_of(problem_, right - 1, sample.traction.left),
                  j == last ? Estimate<R>{} : shear_of(problem_, right, sample.traction.right)};
  sample.gap = Estimate<R>{};
  sample.slope = both(slope_in_contact(weight().point(j)));
  if (data_.ends == SingularKind::edge) {
    if (j == 0) sample.slope.left = {-infinity<R>(), 0};
    if (j == last) sample.slope.right = {infinity<R>(), 0};
  }
  return sample;
}

/// Returns psi - u - C beyond an end, with psi continued. It is negative beside a punch.
template <Real R>
Estimate<R> ClosedForm<R>::below_profile(Side side, const R& distance) const {
  // Outside the contact its derivative is c N |Y|. The rule takes the power of the end as its weight.
  const PanelDensity<R> integrand{
      {R(0), distance, distance},
      side == Side::left ? weight().powers().front() : weight().powers().back(),
      {},
      [&](const Node<R>& node) { return data_.factor * weight().smooth_modulus_beyond(side, node.from_left); }};
  return compliance_ * tanh_sinh::panel_integral(integrand).widened(4 * relative_error_beyond(side, distance));
}

template <Real R>
R ClosedForm<R>::relative_error_beyond(Side side, const R& distance) const {
  return relative_error(side == Side::left ? 0 : weight().panel_count() - 1, 1) + data_.end_error / distance;
}

template <Real R>
Sample<R> ClosedForm<R>::outside(Side side, const R& distance) const {
  const std::size_t last = weight().panel_count();
  const R x = side == Side::left ? weight().point(0) - distance : weight().point(last) + distance;
  // u'/c = psi'/c - N Y, and Y is -|Y| to the left of the contact: the powers sum to an odd number.
  const R ny = data_.factor * weight().modulus_beyond(side, distance);
  const R profile = profile_slope(x);
  const R slope = compliance_ * (side == Side::left ? profile + ny : profile - ny);
  const R slope_error =
      compliance_ * (4 * epsilon<R>() * abs(profile) + relative_error_beyond(side, distance) * abs(ny));

  Sample<R> sample;
  sample.x = to_real<R>(data_.origin) + x;
  sample.slope = both(Estimate<R>{slope, slope_error});
  if (distance <= gap_length(side)) sample.gap = below_profile(side, distance);
  return sample;
}

template <Real R>
typename ClosedForm<R>::LocatedPoint ClosedForm<R>::locate(const Rational& x) const {
  const Rational exact = x - data_.origin;
  const R from_origin = to_real<R>(exact);
  const std::size_t last = weight().panel_count();
  const auto distance_from = [&](std::size_t j) {
    return data_.exact[j] ? to_real<R>(exact - *data_.exact[j]) : from_origin - weight().point(j);
  };
  if (distance_from(0) < 0) return {0, {}, Side::left, -distance_from(0)};
  if (distance_from(last) > 0) return {last - 1, {}, Side::right, distance_from(last)};
  // The last of the points 0..last-1 on the left of x; 0 if there is none.
  std::size_t k = 0;
  for (std::size_t step = std::bit_floor(last); step > 0; step /= 2) {
    if (k + step < last && distance_from(k + step) > 0) k += step;
  }
  for (const std::size_t j : {k, k + 1}) {
    if (distance_from(j) == 0) return {j};
  }
  return {k, Node<R>{from_origin, distance_from(k), -distance_from(k + 1)}};
}

template <Real R>
Sample<R> ClosedForm<R>::at(const LocatedPoint& place) const {
  if (place.beyond) return outside(*place.beyond, place.distance);
  if (!place.inside) return at_point(place.panel);
  return inside(place.panel, *place.inside, traction(place.panel, *place.inside));
}

template <Real R>
Sample<R> ClosedForm<R>::at(const Rational& x) const {
  Sample<R> sample = at(locate(x));
  sample.x = to_real<R>(x);
  return sample;
}

template <Real R>
void ClosedForm<R>::tractions(std::span<const R> x, std::span<R> normal, std::span<R> shear) const {
  std::fill(normal.begin(), normal.end(), R(0));
  std::fill(shear.begin(), shear.end(), R(0));
  PanelFinder<R>(points(), 1)
      .visit(
          x,
          [&](std::size_t panel, std::size_t first, std::span<const R> from_left, std::span<const R> from_right) {
            const std::span<R> values = normal.subspan(first, from_left.size());
            data_.traction(panel, from_left, from_right, values);
            const R ratio = to_real<R>(problem_.shear_ratio(data_.first_piece + panel));
            for (std::size_t i = 0; i < values.size(); ++i) shear[first + i] = ratio * values[i];
          },
          [&](std::size_t i) {
            ContactSolution<R>::tractions(x.subspan(i, 1), normal.subspan(i, 1), shear.subspan(i, 1));
          });
}

template <Real R>
std::vector<std::pair<typename ClosedForm<R>::LocatedPoint, R>> ClosedForm<R>::places(int count) const {
  std::vector<std::pair<LocatedPoint, R>> result;
  const auto add_gap = [&](Side side) {
    const R length = gap_length(side);
    if (length == 0) return;
    for (int i = 0; i < count; ++i) {
      // From left to right: towards the contact on its left side, away from the contact on its right side.
      const auto [forth, back] = chebyshev_position<R>(i, count);
      const std::size_t panel = side == Side::left ? 0 : weight().panel_count() - 1;
      result.push_back({{panel, {}, side, length * (side == Side::left ? back : forth)}, R(0)});
    }
  };
  add_gap(Side::left);
  const std::size_t panels = weight().panel_count();
  const R width = weight().point(panels) - weight().point(0);
  // The points are distributed over the panels: one half equally, the other half in proportion to the length.
  const auto points_before = [&](std::size_t k) {
    const R part = R(static_cast<double>(k)) / static_cast<double>(panels);
    const R length = (weight().point(k) - weight().point(0)) / width;
    return k == panels ? count : static_cast<int>(count * (part + length) / 2);
  };
  for (std::size_t k = 0; k < panels; ++k) {
    const int n = points_before(k + 1) - points_before(k);
    const Panel<R>& panel = weight().panel(k);
    std::vector<R> from_left, from_right, tractions(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
      const auto [left, right] = chebyshev_position<R>(i, n);
      from_left.push_back(left * panel.length);
      from_right.push_back(right * panel.length);
    }
    data_.traction(k, from_left, from_right, tractions);
    for (std::size_t i = 0; i < tractions.size(); ++i) {
      const R& left = from_left[i];
      const R& right = from_right[i];
      const Node<R> node{left < right ? panel.left + left : panel.right - right, left, right};
      result.push_back({{k, node}, tractions[i]});
    }
  }
  add_gap(Side::right);
  return result;
}

template <Real R>
Sample<R> ClosedForm<R>::sample(const std::pair<LocatedPoint, R>& at) const {
  const auto& [place, traction] = at;
  return place.inside ? inside(place.panel, *place.inside, traction) : this->at(place);
}

template <Real R>
std::vector<Sample<R>> ClosedForm<R>::samples(int count) const {
  return mapped(places(count), [this](const auto& place) { return sample(place); });
}

template <Real R>
std::vector<DetailedSample<R>> ClosedForm<R>::detailed_samples(int count) const {
  return mapped(places(count), [this](const auto& place) { return detailed(place.first, sample(place)); });
}

template <Real R>
DetailedSample<R> ClosedForm<R>::details_at(const Rational& x) const {
  const LocatedPoint place = locate(x);
  DetailedSample<R> result = detailed(place, at(place));
  result.x = to_real<R>(x);
  return result;
}

template <Real R>
Estimate<R> ClosedForm<R>::height(const LocatedPoint& place) const {
  R x = place.inside ? place.inside->x : weight().point(place.panel);
  if (place.beyond == Side::left) x = weight().point(0) - place.distance;
  if (place.beyond == Side::right) x = weight().point(weight().panel_count()) + place.distance;
  const Estimate<R> slope = slope_in_contact(x);
  const Estimate<R> height{slope.value * x / 2, slope.error * abs(x)};
  return place.beyond ? height - below_profile(*place.beyond, place.distance) : height;
}

template <Real R>
DetailedSample<R> ClosedForm<R>::detailed(const LocatedPoint& place, const Sample<R>& sample) const {
  const std::size_t k = place.panel;
  const std::size_t last = weight().panel_count();
  DetailedSample<R> result{sample, {}, {}, {}, {}};
  result.displacement =
      height(place) - height_at_origin_([this] { return height(locate(problem_.origin_of_displacement())); });

  LinePlace<R> at{0, infinity<R>(), infinity<R>()};
  if (place.beyond) {
    const bool left = place.beyond == Side::left;
    (left ? at.to_right : at.to_left) = place.distance;
    if (!left) at.panels = last;
    if (place.distance <= gap_length(*place.beyond)) {
      const auto piece = [&](Side side) { return problem_.friction().piece(Rational(sample.x), side); };
      result.friction = {piece(Side::left), piece(Side::right)};
    }
  } else if (place.inside) {
    at = {k, place.inside->from_left, place.inside->from_right, place.inside};
    result.friction = {data_.first_piece + k, data_.first_piece + k};
  } else {
    at.panels = k;
    if (k > 0) at.to_left = 0;
    if (k < last) at.to_right = 0;
    result.friction = {data_.first_piece + (k > 0 ? k - 1 : k), data_.first_piece + std::min(k, last - 1)};
  }
  integrals().add_to(result, at, place.is_point(), compliance_, data_.end_error);
  return result;
}

STEADYSLIDE_INSTANTIATE_CLASS(ClosedForm)

}  // namespace steadyslide::numeric
