#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "numeric/riemann_hilbert/local_signs.hpp"
#include "numeric/riemann_hilbert/traction_density.hpp"
#include "numeric/solution/largest_pressure.hpp"

namespace steadyslide::numeric {

template <Real R>
RiemannHilbertSolution<R>::RiemannHilbertSolution(ContactProblem problem, const Frame& frame, const Search& search)
    : problem_(std::move(problem)),
      compliance_(to_real<R>(problem_.elasticity().compliance())),
      reduced_(problem_, frame),
      unit_(to_real<R>(frame.unit)),
      found_(search(reduced_, rules_)),
      form_(reduced_, found_.state.set, found_.state.q, found_.state.tilt, rules_) {}

template <Real R>
bool RiemannHilbertSolution<R>::has_edge() const {
  const auto& points = contact_set().points();
  return std::any_of(points.begin(), points.end(), [](const auto& p) { return p.is_end() && !p.vanishes; });
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::coordinate(std::size_t j) const {
  const auto& point = contact_set().point(j);
  if (point.anchor) {
    const R x = to_real<R>(reduced_.place(*point.anchor));
    return {x, epsilon<R>() * abs(x)};
  }
  const R offset = unit_ * contact_set().x(j);
  const R x = to_real<R>(reduced_.frame().origin) + offset;
  return {x, unit_ * end_error() + epsilon<R>() * (abs(x) + abs(offset))};
}

template <Real R>
bool RiemannHilbertSolution<R>::in_contact_at(std::size_t j, Side side) const {
  if (side == Side::left) return j > 0 && contact_set().in_contact(j - 1);
  return j < contact_set().segments() && contact_set().in_contact(j);
}

template <Real R>
R RiemannHilbertSolution<R>::relative_end_error(const SurfacePoint<R>& at) const {
  // A displaced free end e changes |x - e|^p, where the effect is largest, and changes each other factor of the
  // traction by about the same amount.
  R sum = 0;
  for (const std::size_t j : contact_set().movable()) {
    const bool is_left = static_cast<std::ptrdiff_t>(j) <= at.segment;
    const R beside = is_left ? at.node.from_left : at.node.from_right;
    const R distance = std::max(beside, R(abs(at.node.x - contact_set().x(j))));
    if (distance > 0)
      sum += 4 * abs(form_.power(j).value) * contact_set().displacement(j, found_.errors.ends) / distance;
  }
  return sum;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::traction(const SurfacePoint<R>& at) const {
  Estimate<R> t = form_.traction(at);
  const auto segment = static_cast<std::size_t>(at.segment);
  // Twice, because q and the tilt depend on the ends.
  t.error += 2 * abs(form_.y().traction_factor(segment)) * form_.modulus(at) * form_.error_of_state(at, found_.errors);
  return t;
}

template <Real R>
R RiemannHilbertSolution<R>::relative_shift(std::size_t j) const {
  const ContactSet<R>& set = contact_set();
  if (!set.point(j).is_movable()) return R(0);
  const std::vector<R> distances = form_.distances(beside(set, j, set.contact_side(j), R(0)));
  R sum = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (i != j) sum += abs(form_.power(i).value / distances[i]);
  }
  // Beside a gap over a notch, B depends on the gap's length like a power of it between -1 and 0.
  if (set.counts_by_order(j)) sum += 1 / std::min(set.length(j - 1), set.length(j));
  return set.displacement(j, found_.errors.ends) * sum;
}

/// Returns the middle of a segment.
template <Real R>
SurfacePoint<R> RiemannHilbertSolution<R>::middle_of(std::size_t segment) const {
  const R half = contact_set().length(segment) / 2;
  return {static_cast<std::ptrdiff_t>(segment), {contact_set().x(segment) + half, half, half}};
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::amplitude(std::size_t j, Side side) const {
  const std::size_t segment = side == Side::left ? j - 1 : j;
  const SurfacePoint<R> at = middle_of(segment);
  const R factor = form_.sign(at.segment) * form_.amplitude(j);
  const R relative = form_.fundamental_solution().relative_error(segment, at.node, R(0)) + 2 * relative_end_error(at);
  Estimate<R> b = form_.regular_factor_at(j, side).widened(relative + 2 * relative_shift(j));
  b.error += 2 * form_.error_of_state(beside(contact_set(), j, side, R(0)), found_.errors);
  return factor * b;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::intensity(std::size_t j) const {
  const bool inside = !contact_set().point(j).is_end();
  const Side side = in_contact_at(j, Side::right) ? Side::right : Side::left;
  const std::size_t friction = form_.friction_at(side == Side::right ? j : j - 1);
  const Estimate<R> t = amplitude(j, side);
  const R power = pow(unit_, -form_.power(j).value);
  // At an end theta contains cos(pi alpha) of the contact side; at a jump its definition does not contain it.
  const R factor = inside ? power : power * reduced_.cos_alpha(friction);
  return -factor * t;
}

template <Real R>
std::optional<InnerTerms> RiemannHilbertSolution<R>::inner_terms_at(std::size_t j) const {
  const auto s = [&](std::size_t segment) { return problem_.coupled_friction(form_.friction_at(segment)); };
  return inner_terms(s(j - 1), s(j), contact_set().anchor_at(j)->exact);
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::constant(std::size_t j) const {
  if (contact_set().point(j).is_end() || !form_.changes_polynomial(j)) return {};
  const std::optional<InnerTerms> terms = inner_terms_at(j);
  if (!terms) return {};
  if (!local_terms(terms->kind).has_logarithm) {
    // From exact data: in R the difference of two close s would lose its digits.
    const R a = to_real<R>(terms->constant);
    return {a, epsilon<R>() * abs(a)};
  }
  // The limit from the left of t - D/(1+s^2) log|x-c|/pi, |x-c| in the user's unit.
  const Estimate<R> t = amplitude(j, Side::left);
  const R& cos_alpha = reduced_.cos_alpha(form_.friction_at(j - 1));
  const R unit = to_real<R>(terms->logarithm) * log(unit_) / pi<R>();
  return cos_alpha * t - Estimate<R>{unit, 4 * epsilon<R>() * abs(unit)};
}

template <Real R>
ContactEnd<R> RiemannHilbertSolution<R>::contact_end(std::size_t j) const {
  const auto& point = contact_set().point(j);
  const bool at_support = point.anchor && (*point.anchor == 0 || *point.anchor + 1 == reduced_.anchors().size());
  return {coordinate(j), end_kind(point.vanishes, at_support), form_.exponent(j), intensity(j)};
}

template <Real R>
std::vector<ContactComponent<R>> RiemannHilbertSolution<R>::contact() const {
  using Kind = typename ContactSet<R>::Kind;
  const std::vector<std::size_t> begins = contact_set().all(Kind::begins);
  const std::vector<std::size_t> ends = contact_set().all(Kind::ends);
  std::vector<ContactComponent<R>> result;
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const R width = unit_ * contact_set().sum_of_lengths(begins[i], ends[i], R(0));
    result.push_back(
        {contact_end(begins[i]), contact_end(ends[i]), {width, 2 * unit_ * end_error() + 4 * epsilon<R>() * width}});
  }
  return result;
}

template <Real R>
std::vector<UnresolvedGap<R>> RiemannHilbertSolution<R>::unresolved_gaps() const {
  std::vector<UnresolvedGap<R>> result;
  for (const HairlineGap<R>& gap : found_.hairline_gaps) {
    const auto log10_length = static_cast<double>((gap.log_length + log(unit_)) / log(R(10)));
    result.push_back({coordinate(contact_set().point_of(gap.anchor)), log10_length});
  }
  return result;
}

template <Real R>
ApproximateContact RiemannHilbertSolution<R>::approximate_contact() const {
  ApproximateContact contact;
  const ContactSet<R>& set = contact_set();
  for (std::size_t j = 0; j < set.points().size(); ++j) {
    const auto& point = set.point(j);
    if (!point.is_end()) continue;
    if (point.anchor) {
      contact.ends.push_back({reduced_.place(*point.anchor), std::nullopt, 0, point.vanishes});
      continue;
    }
    // Lengths are accurate, so use their sums to the anchors on both sides.
    R to_left = 0, to_right = 0;
    std::size_t left = j, right = j;
    while (!set.point(left).anchor) to_left += set.length(--left);
    while (!set.point(right).anchor) to_right += set.length(right++);
    const bool from_left = to_left < to_right;
    contact.ends.push_back({reduced_.place(*set.point(from_left ? left : right).anchor),
                            from_left ? Side::right : Side::left,
                            reduced_.frame().unit * Rational(from_left ? to_left : to_right), true});
  }
  return contact;
}

template <Real R>
std::vector<SolvedSingularPoint<R>> RiemannHilbertSolution<R>::singular_points() const {
  std::vector<SolvedSingularPoint<R>> result;
  for (std::size_t j = 0; j < contact_set().points().size(); ++j) {
    if (contact_set().point(j).is_end()) {
      ContactEnd<R> end = contact_end(j);
      const Estimate<R> there = stress_intensity_of<R>(end.intensity, form_.power(j).value);
      const bool on_right = contact_set().contact_side(j) == Side::right;
      const StressIntensity<R> k = on_right ? StressIntensity<R>{{}, there} : StressIntensity<R>{there, {}};
      result.push_back({end.x, end.kind, std::move(end.exponent), end.intensity, {}, k});
      continue;
    }
    if (!in_contact_at(j, Side::left) || !in_contact_at(j, Side::right)) continue;
    const std::optional<InnerTerms> terms = inner_terms_at(j);
    if (!terms) continue;
    if (local_terms(terms->kind).has_power) {
      const Estimate<R> theta = intensity(j);
      const auto on_side = [&](std::size_t segment) {
        return stress_intensity_of<R>(reduced_.cos_alpha(form_.friction_at(segment)) * theta, form_.power(j).value);
      };
      result.push_back(
          {coordinate(j), terms->kind, form_.exponent(j), theta, constant(j), {on_side(j - 1), on_side(j)}});
    } else {
      const R theta = to_real<R>(terms->logarithm);
      result.push_back({coordinate(j), terms->kind, std::nullopt, {theta, epsilon<R>() * abs(theta)}, constant(j), {}});
    }
  }
  return result;
}

template <Real R>
const SurfaceCheck<R>& RiemannHilbertSolution<R>::check() const {
  return check_([this] {
    std::vector<R> s;
    for (const std::size_t k : contact_set().contact_segments()) s.push_back(reduced_.s(form_.friction_at(k)));
    return SurfaceCheck<R>(traction_density(form_), std::move(s), [this](std::size_t panel, const Node<R>& node) {
      const std::size_t segment = contact_set().contact_segments()[panel];
      return R(reduced_.slope(form_.slope_at(segment), node.x) + form_.tilt());
    });
  });
}

template <Real R>
Resultants<R> RiemannHilbertSolution<R>::resultants() const {
  return resultants_([this] {
    std::vector<Estimate<R>> on_pieces(problem_.friction().values().size());
    std::vector<Estimate<R>> on_components;
    auto load = loads().begin();
    for (const std::size_t k : contact_set().contact_segments()) {
      if (contact_set().point(k).is_end()) on_components.emplace_back();
      const Estimate<R> here = -unit_ * *load++;
      on_pieces[form_.friction_at(k)] += here;
      on_components.back() += here;
    }
    Resultants<R> result = resultants_of(on_pieces, problem_.friction().values());
    result.component_load = std::move(on_components);
    const R origin = to_real<R>(reduced_.frame().origin);
    const Estimate<R> offset = unit_ * form_.moment_of_load() / reduced_.load();
    // The change of the centre due to free ends is at most the relative change of the load times the contact's length.
    const R ends =
        8 * unit_ * end_error() + unit_ * contact_set().span_length() * result.normal.error / result.normal.value;
    result.centre_of_pressure = {origin + offset.value,
                                 offset.error + epsilon<R>() * (abs(origin) + 32 * unit_) + ends};
    return result;
  });
}

template <Real R>
const std::vector<Estimate<R>>& RiemannHilbertSolution<R>::loads() const {
  return loads_([this] {
    // The samples of the check exist or will be needed soon. In higher precision than double, Gauss-Jacobi rules for
    // this alone would cost ten times as much; in double, a rule of its own for each of many panels costs more than the
    // whole solve.
    constexpr std::size_t many = 1000;
    const bool samples = !std::same_as<R, double> || contact_set().contact_segments().size() > many;
    const auto load_on = [&](std::size_t segment, std::size_t panel) -> Estimate<R> {
      if (samples) {
        if (const auto load = check().panel_integral(panel)) return *load;
      }
      if (!form_.changes_polynomial(segment) && !form_.changes_polynomial(segment + 1)) return form_.load_on(segment);
      return tanh_sinh::panel_integral(panel_density(form_, segment));
    };
    std::vector<Estimate<R>> result;
    for (const std::size_t k : contact_set().contact_segments()) {
      // Rules for a density do not include the error of the traction.
      result.push_back(load_on(k, result.size()));
      result.back().error += form_.integral_of_error(whole_segment(contact_set(), k),
                                                     [this](const SurfacePoint<R>& at) { return traction(at).error; });
    }
    return result;
  });
}

template <Real R>
LargestPressure<R> RiemannHilbertSolution<R>::largest_pressure() const {
  if (const auto infinite = infinite_pressure(singular_points())) return *infinite;
  const ContactSet<R>& set = contact_set();
  LargestPressure<R> largest;
  std::vector<R> lengths;
  for (const std::size_t k : set.contact_segments()) {
    lengths.push_back(set.length(k));
    const Estimate<R> limit = -traction_limit(k, Side::right);
    if (limit.value > largest.value.value) largest = {limit, coordinate(k), std::nullopt};
  }
  const auto place = [&](std::size_t panel, const R& left, const R& right) {
    return surface_point(set, set.contact_segments()[panel], left, right);
  };
  const PanelFunction<R> pressure = [&](std::size_t panel, const R& left, const R& right) {
    const SurfacePoint<R> at = place(panel, left, right);
    return -traction(at).widened(relative_end_error(at));
  };
  return finite_pressure<R>(largest, lengths, pressure, [&](const Peak<R>& peak) -> Estimate<R> {
    const R offset = unit_ * place(peak.panel, peak.from_left, peak.from_right).node.x;
    const R origin = to_real<R>(reduced_.frame().origin);
    const R error = unit_ * (peak.place_error + end_error());
    return {origin + offset, error + 2 * epsilon<R>() * (abs(origin) + abs(offset))};
  });
}

template <Real R>
std::optional<Estimate<R>> RiemannHilbertSolution<R>::tilt() const {
  if (!problem_.load_at()) return std::nullopt;
  const R value = compliance_ * form_.tilt();
  return Estimate<R>{value, 64 * epsilon<R>() * (abs(value) + compliance_ * reduced_.load()) +
                                compliance_ * (end_error() + found_.errors.tilt)};
}

template <Real R>
EstimatedError<R> RiemannHilbertSolution<R>::estimated_error() const {
  return estimated_error_([this] {
    EstimatedError<R> worst{max(end_error() / contact_set().span_length(), epsilon<R>()), R(0), R(0)};
    for (const std::size_t k : contact_set().contact_segments()) {
      const SurfacePoint<R> at = middle_of(k);
      const Estimate<R> t = traction(at);
      if (t.value != 0) worst.traction = max(worst.traction, t.error / abs(t.value));
    }
    const Resultants<R> r = resultants();
    worst.resultants = r.normal.error / r.normal.value;
    return worst;
  });
}

template <Real R>
Residuals<R> RiemannHilbertSolution<R>::residuals() const {
  const std::vector<std::size_t>& segments = contact_set().contact_segments();
  R contact_length = 0;
  for (const std::size_t k : segments) contact_length += contact_set().length(k);
  const R& load = reduced_.load();
  Residuals<R> result;
  result.equation = check().equation();
  result.load = abs(check().integral() + load) / load;
  // Use the samples at places, and the limits at singular points, which no place may show.
  const R limit = highest_limit(form_, end_error());
  result.tension = max({check().highest_traction(), limit, R(0)}) * contact_length / load;

  // Gaps: compare the profile with the displacement, both measured from the end of contact next to the place.
  R deepest = 0;
  std::map<std::size_t, GapIntegral<R>> gaps;  // by their ends
  for (std::size_t k = 0; k < contact_set().segments(); ++k) {
    if (contact_set().in_contact(k)) continue;
    std::vector<SurfacePoint<R>> all = form_.profile_extrema(k);
    const R& length = contact_set().length(k);
    for (const R& part : gap_places<R>()) {
      all.push_back(surface_point(contact_set(), k, R(part * length), R((1 - part) * length)));
    }
    for (const SurfacePoint<R>& at : all) {
      const std::optional<std::size_t> end = nearest_end(at);
      if (!end) continue;
      const auto panel =
          std::lower_bound(segments.begin(), segments.end(), contact_set().inside(*end)) - segments.begin();
      const R distance = abs(form_.distance(at, *end));
      const Side side = opposite(contact_set().contact_side(*end));
      const R rise = gaps.try_emplace(*end, form_, *end).first->second.profile_increment(at);
      deepest = max(deepest, check().penetration(static_cast<std::size_t>(panel), side, distance, rise));
    }
  }
  result.penetration = deepest / load;
  return result;
}

STEADYSLIDE_INSTANTIATE_CLASS(RiemannHilbertSolution)

}  // namespace steadyslide::numeric
