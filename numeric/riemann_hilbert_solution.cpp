#include "numeric/riemann_hilbert_solution.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/clustered.hpp"
#include "numeric/residuals.hpp"
#include "numeric/tanh_sinh.hpp"

namespace steadyslide::numeric {

template <Real R>
RiemannHilbertSolution<R>::RiemannHilbertSolution(ContactProblem problem, const Frame& frame)
    : problem_(std::move(problem)), reduced_(problem_, frame) {}

template <Real R>
void RiemannHilbertSolution<R>::set(SearchResult<R> found) {
  found_ = std::move(found);
  form_.emplace(reduced_, found_->state.set, found_->state.q, found_->state.tilt, rules_);
}

template <Real R>
bool RiemannHilbertSolution<R>::has_edge() const {
  const auto& points = contact_set().points();
  return std::any_of(points.begin(), points.end(), [](const auto& p) { return p.is_end() && !p.vanishes; });
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::coordinate(std::size_t j) const {
  using std::abs;
  const auto& point = contact_set().point(j);
  if (point.anchor) {
    const R x = to_real<R>(reduced_.place(*point.anchor));
    return {x, epsilon<R>() * abs(x)};
  }
  const R offset = to_real<R>(reduced_.frame().unit) * contact_set().x(j);
  const R x = to_real<R>(reduced_.frame().origin) + offset;
  return {x, to_real<R>(reduced_.frame().unit) * found_->end_error + epsilon<R>() * (abs(x) + abs(offset))};
}

template <Real R>
bool RiemannHilbertSolution<R>::in_contact_at(std::size_t j, Side side) const {
  if (side == Side::left) return j > 0 && contact_set().in_contact(j - 1);
  return j < contact_set().segments() && contact_set().in_contact(j);
}

template <Real R>
R RiemannHilbertSolution<R>::profile_jump(std::size_t j) const {
  if (!form_->is_kinked(j)) return R(0);
  const R& x = contact_set().x(j);
  return reduced_.slope(form_->slope_at(j), x) - reduced_.slope(form_->slope_at(j - 1), x);
}

template <Real R>
R RiemannHilbertSolution<R>::relative_end_error(const SurfacePoint<R>& at) const {
  // What a displaced free end e does to |x - e|^p, next to where it matters most.
  using std::abs;
  R sum = 0;
  for (const std::size_t j : contact_set().movable()) {
    const R distance = abs(form_->distance(at, j));
    if (distance > 0) sum += abs(form_->weight().powers()[j].value) * found_->end_error / distance;
  }
  return sum;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::intensity(std::size_t j) const {
  using std::abs, std::pow;
  const bool inside = !contact_set().point(j).is_end();
  const Side side = in_contact_at(j, Side::right) ? Side::right : Side::left;
  const std::size_t segment = side == Side::right ? j : j - 1;
  if (inside && form_->exponent(j).sign() == 0) {
    // A wedge: the coefficient of log|x - c|/pi.
    const R& s = reduced_.s(form_->friction_at(segment));
    const R theta = profile_jump(j) / (1 + s * s);
    return {theta, 8 * epsilon<R>() * abs(theta)};
  }
  const R p = form_->weight().powers()[j].value;
  const Estimate<R> b = form_->bracket_at(j, side);
  R factor = -form_->sign(static_cast<std::ptrdiff_t>(segment)) * form_->weight().amplitude(j) *
             pow(to_real<R>(reduced_.frame().unit), R(-p));
  // At an end theta carries the cos(pi alpha) of the contact side; at a jump the definition takes it out.
  if (!inside) factor *= reduced_.cos_alpha(form_->friction_at(segment));
  const R half = contact_set().length(segment) / 2;
  const Node<R> node{contact_set().x(segment) + half, half, half};
  const R relative = form_->weight().relative_error(segment, node, R(0)) +
                     4 * relative_end_error({static_cast<std::ptrdiff_t>(segment), node});
  return {factor * b.value, abs(factor) * (b.error + relative * abs(b.value))};
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::constant(std::size_t j) const {
  using std::abs, std::log;
  if (contact_set().point(j).is_end() || !form_->is_kinked(j)) return {};
  const R d = profile_jump(j);
  const R& s_left = reduced_.s(form_->friction_at(j - 1));
  const R& s_right = reduced_.s(form_->friction_at(j));
  if (form_->exponent(j).sign() != 0) {
    const R a = d / (s_right - s_left);
    return {a, 8 * epsilon<R>() * abs(a)};
  }
  // The limit from the left of t - D/(1+s^2) log|x-c|/pi, |x-c| in the user's unit.
  const std::size_t segment = j - 1;
  const Estimate<R> b = form_->bracket_at(j, Side::left);
  const R factor = form_->sign(static_cast<std::ptrdiff_t>(segment)) * form_->weight().amplitude(j) *
                   reduced_.cos_alpha(form_->friction_at(segment));
  const R unit = d / (1 + s_left * s_left) * log(to_real<R>(reduced_.frame().unit)) / pi<R>();
  return {factor * b.value - unit,
          abs(factor) * (b.error + 32 * epsilon<R>() * abs(b.value)) + epsilon<R>() * abs(unit)};
}

template <Real R>
ContactEnd<R> RiemannHilbertSolution<R>::contact_end(std::size_t j) const {
  const auto& point = contact_set().point(j);
  SingularKind kind = SingularKind::free;
  if (!point.vanishes) {
    const bool at_support = *point.anchor == 0 || *point.anchor + 1 == reduced_.anchors().size();
    kind = at_support ? SingularKind::edge : SingularKind::step;
  }
  return {coordinate(j), kind, form_->exponent(j), intensity(j)};
}

template <Real R>
std::vector<ContactComponent<R>> RiemannHilbertSolution<R>::contact() const {
  using Kind = typename ContactSet<R>::Kind;
  const std::vector<std::size_t> begins = contact_set().all(Kind::begins);
  const std::vector<std::size_t> ends = contact_set().all(Kind::ends);
  std::vector<ContactComponent<R>> result;
  for (std::size_t i = 0; i < begins.size(); ++i) result.push_back({contact_end(begins[i]), contact_end(ends[i])});
  return result;
}

template <Real R>
std::vector<SolvedSingularPoint<R>> RiemannHilbertSolution<R>::singular_points() const {
  std::vector<SolvedSingularPoint<R>> result;
  for (std::size_t j = 0; j < contact_set().points().size(); ++j) {
    if (contact_set().point(j).is_end()) {
      ContactEnd<R> end = contact_end(j);
      result.push_back({end.x, end.kind, std::move(end.exponent), end.intensity, {}});
      continue;
    }
    if (!in_contact_at(j, Side::left) || !in_contact_at(j, Side::right)) continue;
    const Exponent& beta = form_->exponent(j);
    const bool wedge = reduced_.anchors()[*contact_set().point(j).anchor].wedge;
    if (beta.sign() != 0) {
      const SingularKind kind = wedge ? SingularKind::wedge_and_jump : SingularKind::friction_jump;
      result.push_back({coordinate(j), kind, beta, intensity(j), constant(j)});
    } else if (wedge) {
      result.push_back({coordinate(j), SingularKind::wedge, std::nullopt, intensity(j), constant(j)});
    }
  }
  return result;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::load_on(std::size_t segment) const {
  if (!form_->is_kinked(segment) && !form_->is_kinked(segment + 1)) return form_->load_on(segment);
  return tanh_sinh::panel_integral(panel_density(segment));
}

template <Real R>
Resultants<R> RiemannHilbertSolution<R>::resultants() const {
  using std::abs;
  const R unit = to_real<R>(reduced_.frame().unit);
  const std::vector<Rational>& friction = problem_.friction().values();
  Resultants<R> result;
  result.load_share.resize(friction.size());
  for (std::size_t k = 0; k < contact_set().segments(); ++k) {
    if (!contact_set().in_contact(k)) continue;
    const Estimate<R> load = load_on(k);
    const R half = contact_set().length(k) / 2;
    const R ends = 8 * relative_end_error({static_cast<std::ptrdiff_t>(k), {contact_set().x(k) + half, half, half}});
    Estimate<R>& share = result.load_share[form_->friction_at(k)];
    share.value -= unit * load.value;
    share.error += unit * (load.error + ends * abs(load.value));
    result.normal.value -= unit * load.value;
    result.normal.error += unit * (load.error + ends * abs(load.value));
    if (load.convergence == Convergence::stalled) result.normal.convergence = Convergence::stalled;
  }
  const R relative = result.normal.error / result.normal.value;
  result.effective_friction.convergence = result.normal.convergence;
  for (std::size_t k = 0; k < friction.size(); ++k) {
    Estimate<R>& share = result.load_share[k];
    share.value /= result.normal.value;
    share.error = share.error / result.normal.value + relative * share.value;
    const R f = to_real<R>(friction[k]);
    result.effective_friction.value += f * share.value;
    result.effective_friction.error += f * share.error;
  }
  const R& mu = result.effective_friction.value;
  result.tangential = {mu * result.normal.value,
                       result.effective_friction.error * result.normal.value + mu * result.normal.error,
                       result.normal.convergence};
  const R origin = to_real<R>(reduced_.frame().origin);
  const R offset = unit * form_->moment_of_load() / reduced_.load();
  result.centre_of_pressure = {origin + offset,
                               epsilon<R>() * (abs(origin) + 32 * unit) + 8 * unit * found_->end_error};
  return result;
}

template <Real R>
std::optional<Estimate<R>> RiemannHilbertSolution<R>::tilt() const {
  using std::abs;
  if (!problem_.load_at()) return std::nullopt;
  const R c = to_real<R>(problem_.elasticity().compliance());
  const R value = c * form_->tilt();
  return Estimate<R>{value, 64 * epsilon<R>() * (abs(value) + c * reduced_.load()) + c * found_->end_error};
}

template <Real R>
EstimatedError<R> RiemannHilbertSolution<R>::estimated_error() const {
  using std::abs, std::max;
  EstimatedError<R> worst{max(R(found_->end_error / contact_set().hull()), epsilon<R>()), R(0), R(0)};
  for (std::size_t k = 0; k < contact_set().segments(); ++k) {
    if (!contact_set().in_contact(k)) continue;
    const R half = contact_set().length(k) / 2;
    const SurfacePoint<R> at{static_cast<std::ptrdiff_t>(k), {contact_set().x(k) + half, half, half}};
    const Estimate<R> t = form_->traction(at);
    if (t.value != 0) worst.traction = max(worst.traction, R(t.error / abs(t.value) + relative_end_error(at)));
  }
  const Resultants<R> r = resultants();
  worst.resultants = r.normal.error / r.normal.value;
  return worst;
}

template <Real R>
Power<R> RiemannHilbertSolution<R>::traction_power(std::size_t j) const {
  const Power<R>& p = form_->weight().powers()[j];
  // At a wedge the constant, or the logarithm, is larger than a power that vanishes.
  if (form_->is_kinked(j) && p.value > 0) return {R(0), R(1)};
  return p;
}

template <Real R>
PanelDensity<R> RiemannHilbertSolution<R>::panel_density(std::size_t segment) const {
  const Power<R> left = traction_power(segment);
  const Power<R> right = traction_power(segment + 1);
  const auto smooth = [this, segment, left, right](const Node<R>& node) {
    using std::pow;
    const SurfacePoint<R> at{static_cast<std::ptrdiff_t>(segment), node};
    const R& p_left = form_->weight().powers()[segment].value;
    const R& p_right = form_->weight().powers()[segment + 1].value;
    R value = form_->sign(at.segment) * reduced_.cos_alpha(form_->friction_at(segment)) *
              form_->weight().smooth_modulus(segment, node) * form_->bracket(form_->slope_at(segment), at).value;
    if (p_left != left.value) value *= pow(node.from_left, p_left);
    if (p_right != right.value) value *= pow(node.from_right, p_right);
    return value;
  };
  PanelDensity<R> density{contact_set().panels()[segment], left, right, smooth, R(0)};
  for (std::size_t k = segment; k-- > 0 && !contact_set().in_contact(k);) density.gap += contact_set().length(k);
  return density;
}

template <Real R>
Residuals<R> RiemannHilbertSolution<R>::residuals() const {
  using std::abs, std::max;
  PiecewiseDensity<R> density;
  std::vector<R> s;
  std::vector<std::size_t> segments;
  R contact_length = 0;
  for (std::size_t k = 0; k < contact_set().segments(); ++k) {
    if (!contact_set().in_contact(k)) continue;
    density.push_back(panel_density(k));
    s.push_back(reduced_.s(form_->friction_at(k)));
    segments.push_back(k);
    contact_length += contact_set().length(k);
  }
  const SurfaceCheck<R> check(std::move(density), s, [&](std::size_t panel, const Node<R>& node) {
    return R(reduced_.slope(form_->slope_at(segments[panel]), node.x) + form_->tilt());
  });
  const R& load = reduced_.load();
  Residuals<R> result;
  result.equation = check.equation();
  result.load = abs(check.integral() + load) / load;
  result.tension = max(check.highest_traction(), R(0)) * contact_length / load;

  // Gaps: the profile against the displacement, both from the end of the contact that is next to the place.
  R deepest = 0;
  constexpr int places = 8;
  for (std::size_t k = 0; k < contact_set().segments(); ++k) {
    if (contact_set().in_contact(k)) continue;
    std::vector<SurfacePoint<R>> all = form_->extremes(k);
    for (int i = 0; i < places; ++i) {
      const auto [left, right] = clustered<R>(i, places);
      const R& length = contact_set().length(k);
      all.push_back({static_cast<std::ptrdiff_t>(k),
                     {left < right ? R(contact_set().x(k) + left * length) : R(contact_set().x(k + 1) - right * length),
                      left * length, right * length}});
    }
    for (const SurfacePoint<R>& at : all) {
      const std::optional<std::size_t> end = nearest_end(at);
      if (!end) continue;
      const bool on_left = contact_set().point(*end).kind == ContactSet<R>::Kind::ends;
      const std::size_t segment = on_left ? *end - 1 : *end;
      const auto panel =
          static_cast<std::size_t>(std::find(segments.begin(), segments.end(), segment) - segments.begin());
      const R distance = abs(form_->distance(at, *end));
      const R surface = check.displacement(panel, on_left ? Side::right : Side::left, distance);
      const R gap = form_->profile_rise(*end, at) - surface;
      deepest = max(deepest, R(-gap));
    }
  }
  result.penetration = deepest / load;
  return result;
}

template <Real R>
R RiemannHilbertSolution<R>::shear_ratio(std::size_t segment) const {
  // The body is dragged along: t_t = -f t towards the side to which the indenter slides.
  const R f = to_real<R>(problem_.friction().values()[form_->friction_at(segment)]);
  if (f == 0) return R(0);
  return problem_.sliding() == Sliding::plus_x ? R(-f) : f;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::shear_of(const Estimate<R>& traction, std::size_t segment) const {
  using std::abs;
  const R ratio = shear_ratio(segment);
  if (ratio == 0) return {};
  return {ratio * traction.value, abs(ratio) * traction.error};
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::tangential_slope(const Rational& x) const {
  using std::abs;
  const SurfacePoint<R> at = locate(x);
  // With one ratio r = t_t/t everywhere the integral would be r (u'/c - s t). What is left for other ratios keeps clear
  // of x: no principal value.
  std::size_t nearest = contact_set().all(ContactSet<R>::Kind::begins).front();
  for (std::size_t k = 0; k < contact_set().segments(); ++k) {
    const auto distance = [&](std::size_t segment) {
      if (static_cast<std::ptrdiff_t>(segment) == at.segment) return R(0);
      return std::min(R(abs(form_->distance(at, segment))), R(abs(form_->distance(at, segment + 1))));
    };
    if (contact_set().in_contact(k) && distance(k) < distance(nearest)) nearest = k;
  }
  const R ratio = shear_ratio(nearest);
  const Estimate<R> t = form_->traction(at);
  const Estimate<R> slope = form_->surface_slope(at);
  const R gamma = to_real<R>(problem_.elasticity().gamma());
  const R s = reduced_.s(form_->friction_at(nearest));
  Estimate<R> sum{ratio * (slope.value - s * t.value) + gamma * t.value,
                  abs(ratio) * slope.error + (abs(ratio * s) + abs(gamma)) * t.error};
  for (std::size_t k = 0; k < contact_set().segments(); ++k) {
    if (!contact_set().in_contact(k) || shear_ratio(k) == ratio) continue;
    const bool on_right = static_cast<std::ptrdiff_t>(k) > at.segment;
    const R distance = abs(form_->distance(at, on_right ? k : k + 1));
    const Estimate<R> part = tanh_sinh::cauchy<R>({panel_density(k)}, on_right ? Side::left : Side::right, distance);
    sum.value += (shear_ratio(k) - ratio) * part.value;
    sum.error += abs(shear_ratio(k) - ratio) * part.error;
    if (part.convergence == Convergence::stalled) sum.convergence = Convergence::stalled;
  }
  const R c = to_real<R>(problem_.elasticity().compliance());
  return {c * sum.value, c * sum.error, sum.convergence};
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
  return form_->distance(at, *left) <= -form_->distance(at, *right) ? left : right;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::gap(const SurfacePoint<R>& at) const {
  using std::abs;
  if (contact_set().in_contact(static_cast<std::size_t>(at.segment))) return {};
  const std::optional<std::size_t> end = nearest_end(at);
  if (!end) return {};
  const Estimate<R> opening = form_->opening(*end, at);
  const R scale = to_real<R>(problem_.elasticity().compliance()) * to_real<R>(reduced_.frame().unit);
  const R distance = abs(form_->distance(at, *end));
  const R ends = distance > 0 ? R(2 * found_->end_error / distance) : R(0);
  return {scale * opening.value, scale * (opening.error + ends * abs(opening.value))};
}

template <Real R>
Sample<R> RiemannHilbertSolution<R>::sample(const SurfacePoint<R>& at) const {
  using std::abs;
  const R c = to_real<R>(problem_.elasticity().compliance());
  Sample<R> result;
  result.x = to_real<R>(reduced_.frame().origin) + to_real<R>(reduced_.frame().unit) * at.node.x;
  const R ends = relative_end_error(at);
  Estimate<R> slope = form_->surface_slope(at);
  const bool in_support = at.segment >= 0 && at.segment < static_cast<std::ptrdiff_t>(contact_set().segments());
  if (in_support) result.gap = gap(at);
  if (in_support && contact_set().in_contact(static_cast<std::size_t>(at.segment))) {
    Estimate<R> t = form_->traction(at);
    t.error += ends * abs(t.value);
    const Estimate<R> shear = shear_of(t, static_cast<std::size_t>(at.segment));
    result.traction = {t, t};
    result.shear = {shear, shear};
  } else {
    slope.error += ends * abs(slope.value);
  }
  slope = {c * slope.value, c * slope.error};
  result.slope = {slope, slope};
  return result;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::traction_limit(std::size_t j, Side side) const {
  if (!in_contact_at(j, side)) return {};
  const Exponent& p = form_->weight().powers()[j].value == 0 ? Exponent(0) : form_->exponent(j);
  if (p.sign() < 0) return {-infinity<R>(), R(0)};
  if (form_->is_kinked(j)) {
    const R d = profile_jump(j);
    if (p.sign() > 0) return constant(j);
    // Without a corner (only the curvature changes) the logarithm is multiplied by zero.
    if (reduced_.anchors()[*contact_set().point(j).anchor].wedge) {
      return {d > 0 ? R(-infinity<R>()) : infinity<R>(), R(0)};
    }
  }
  if (p.sign() > 0) return {};
  const std::size_t segment = side == Side::left ? j - 1 : j;
  const R& length = contact_set().length(segment);
  const R factor = form_->sign(static_cast<std::ptrdiff_t>(segment)) * form_->weight().amplitude(j) *
                   reduced_.cos_alpha(form_->friction_at(segment));
  const Estimate<R> b = form_->bracket_at(j, side);
  using std::abs;
  const Node<R> node{contact_set().x(segment) + length / 2, length / 2, length / 2};
  const R relative = form_->weight().relative_error(segment, node, R(0)) +
                     4 * relative_end_error({static_cast<std::ptrdiff_t>(segment), node});
  return {factor * b.value, abs(factor) * (b.error + relative * abs(b.value))};
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::slope_limit(std::size_t j, Side side) const {
  using std::abs;
  const R c = to_real<R>(problem_.elasticity().compliance());
  const auto& point = contact_set().point(j);
  const bool contact = in_contact_at(j, side);
  if (!contact && point.is_end() && !point.vanishes) {
    return {side == Side::left ? R(-infinity<R>()) : infinity<R>(), R(0)};
  }
  const auto segments = static_cast<std::ptrdiff_t>(contact_set().segments());
  std::ptrdiff_t segment = static_cast<std::ptrdiff_t>(j) - (side == Side::left ? 1 : 0);
  if (contact || point.is_end()) {
    // The surface leaves a free end along the profile of the contact.
    if (!contact) segment += side == Side::left ? 1 : -1;
    const R slope =
        reduced_.slope(form_->slope_at(static_cast<std::size_t>(segment)), contact_set().x(j)) + form_->tilt();
    return {c * slope, 8 * epsilon<R>() * c * abs(slope)};
  }
  // Off the contact the surface is smooth, whatever the profile does above it.
  const R zero = 0;
  SurfacePoint<R> at{segment, {contact_set().x(j), zero, zero}};
  if (segment >= 0 && segment < segments) {
    const R& length = contact_set().length(static_cast<std::size_t>(segment));
    (side == Side::left ? at.node.from_left : at.node.from_right) = length;
  }
  const Estimate<R> slope = form_->surface_slope(at);
  return {c * slope.value, c * slope.error};
}

template <Real R>
Sample<R> RiemannHilbertSolution<R>::sample_at_point(std::size_t j) const {
  Sample<R> result;
  result.x = coordinate(j).value;
  result.traction = {traction_limit(j, Side::left), traction_limit(j, Side::right)};
  result.shear = {j == 0 ? Estimate<R>{} : shear_of(result.traction.left, j - 1),
                  j == contact_set().segments() ? Estimate<R>{} : shear_of(result.traction.right, j)};
  result.slope = {slope_limit(j, Side::left), slope_limit(j, Side::right)};
  if (in_contact_at(j, Side::left) || in_contact_at(j, Side::right)) {
    result.gap = Estimate<R>{};
  } else {
    // At the support's ends the only segment is the inner one; at a step, the side of the lower gap.
    const std::size_t segments = contact_set().segments();
    std::optional<Estimate<R>> lowest;
    for (const Side side : {Side::left, Side::right}) {
      if ((side == Side::left && j == 0) || (side == Side::right && j == segments)) continue;
      const std::size_t k = side == Side::left ? j - 1 : j;
      const R& length = contact_set().length(k);
      const SurfacePoint<R> at{
          static_cast<std::ptrdiff_t>(k),
          {contact_set().x(j), side == Side::left ? length : R(0), side == Side::left ? R(0) : length}};
      const Estimate<R> here = gap(at);
      if (!lowest || here.value < lowest->value) lowest = here;
    }
    result.gap = lowest;
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
  if (x < reduced_.place(0)) return {-1, {xi, infinity<R>(), R(-from(0))}};
  if (x > reduced_.place(last)) return {static_cast<std::ptrdiff_t>(set.segments()), {xi, from(last), infinity<R>()}};

  std::size_t interval = 0;
  while (interval + 1 < last && x > reduced_.place(interval + 1)) ++interval;
  std::size_t first = 0;
  while (set.point(first).anchor != interval) ++first;
  std::size_t end = first + 1;
  while (!set.point(end).anchor) ++end;
  // Distances from the points of the interval, by way of the anchor that is nearer; by coordinates if both are far.
  const R left = from(interval);
  const R right = -from(interval + 1);
  const bool left_is_near = left < right;
  const auto to_point = [&](std::size_t j) {
    if (!set.point(j).anchor && left > 4 && right > 4) return R(set.x(j) - xi);
    R d = left_is_near ? left : right;
    if (left_is_near) {
      for (std::size_t k = first; k < j; ++k) d -= set.length(k);
      return R(-d);
    }
    for (std::size_t k = j; k < end; ++k) d -= set.length(k);
    return d;
  };
  std::size_t segment = first;
  while (segment + 1 < end && to_point(segment + 1) < 0) ++segment;
  return {static_cast<std::ptrdiff_t>(segment), {xi, R(-to_point(segment)), to_point(segment + 1)}};
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

template <Real R>
std::vector<Sample<R>> RiemannHilbertSolution<R>::samples(int count) const {
  std::vector<Sample<R>> result;
  const ContactSet<R>& set = contact_set();
  std::size_t first = 0;
  while (first < set.segments()) {
    std::size_t end = first + 1;
    while (end < set.segments() && set.in_contact(end) == set.in_contact(first)) ++end;
    R width = 0;
    for (std::size_t k = first; k < end; ++k) width += set.length(k);
    // Each segment gets its part of the count, half of it by number and half by length.
    R before = 0;
    int done = 0;
    for (std::size_t k = first; k < end; ++k) {
      before += set.length(k);
      const R part = R(static_cast<double>(k + 1 - first)) / static_cast<double>(end - first);
      const int until = k + 1 == end ? count : static_cast<int>(R(count * (part + before / width) / 2));
      const int n = until - done;
      for (int i = 0; i < n; ++i) {
        const auto [left, right] = clustered<R>(i, n);
        const R x = left < right ? R(set.x(k) + left * set.length(k)) : R(set.x(k + 1) - right * set.length(k));
        result.push_back(
            sample({static_cast<std::ptrdiff_t>(k), {x, R(left * set.length(k)), R(right * set.length(k))}}));
      }
      done = until;
    }
    first = end;
  }
  return result;
}

template class RiemannHilbertSolution<double>;
template class RiemannHilbertSolution<Real50>;
template class RiemannHilbertSolution<Real100>;

}  // namespace steadyslide::numeric
