#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/cauchy/traction_density.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/solution/load_sharing.hpp"

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
R RiemannHilbertSolution<R>::relative_end_error(const SurfacePoint<R>& at) const {
  // What a displaced free end e does to |x - e|^p, next to where it matters most, and about as much again to every
  // other factor of the traction.
  using std::abs;
  R sum = 0;
  for (const std::size_t j : contact_set().movable()) {
    const R distance = abs(form_->distance(at, j));
    if (distance > 0) sum += 4 * abs(form_->fundamental_solution().powers()[j].value) * found_->end_error / distance;
  }
  return sum;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::amplitude(std::size_t j, Side side) const {
  using std::abs;
  const std::size_t segment = side == Side::left ? j - 1 : j;
  const R& length = contact_set().length(segment);
  const Estimate<R> b = form_->regular_factor_at(j, side);
  const R factor = form_->sign(static_cast<std::ptrdiff_t>(segment)) * form_->fundamental_solution().amplitude(j);
  const Node<R> node{contact_set().x(segment) + length / 2, length / 2, length / 2};
  const R relative = form_->fundamental_solution().relative_error(segment, node, R(0)) +
                     2 * relative_end_error({static_cast<std::ptrdiff_t>(segment), node});
  return factor * b.widened(relative);
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::intensity(std::size_t j) const {
  using std::abs, std::pow;
  const bool inside = !contact_set().point(j).is_end();
  const Side side = in_contact_at(j, Side::right) ? Side::right : Side::left;
  const std::size_t friction = form_->friction_at(side == Side::right ? j : j - 1);
  if (inside && form_->exponent(j).sign() == 0) {
    // A wedge: the coefficient of log|x - c|/pi.
    const Rational s = problem_.coupled_friction(friction);
    const R theta = to_real<R>(Rational(wedge(j) / (1 + s * s)));
    return {theta, epsilon<R>() * abs(theta)};
  }
  const Estimate<R> t = amplitude(j, side);
  const R power = pow(to_real<R>(reduced_.frame().unit), R(-form_->fundamental_solution().powers()[j].value));
  // At an end theta carries the cos(pi alpha) of the contact side; at a jump the definition takes it out.
  const R factor = inside ? power : R(power * reduced_.cos_alpha(friction));
  return R(-factor) * t;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::constant(std::size_t j) const {
  using std::abs, std::log;
  if (contact_set().point(j).is_end() || !form_->changes_polynomial(j)) return {};
  const Rational& d = wedge(j);
  const Rational s = problem_.coupled_friction(form_->friction_at(j - 1));
  if (form_->exponent(j).sign() != 0) {
    // From exact data: next to each other the two s have lost their difference in R.
    const R a = to_real<R>(Rational(d / (problem_.coupled_friction(form_->friction_at(j)) - s)));
    return {a, epsilon<R>() * abs(a)};
  }
  // The limit from the left of t - D/(1+s^2) log|x-c|/pi, |x-c| in the user's unit.
  const Estimate<R> t = amplitude(j, Side::left);
  const R& cos_alpha = reduced_.cos_alpha(form_->friction_at(j - 1));
  const R unit = to_real<R>(Rational(d / (1 + s * s))) * log(to_real<R>(reduced_.frame().unit)) / pi<R>();
  return cos_alpha * t - Estimate<R>{unit, 4 * epsilon<R>() * abs(unit)};
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
    const bool has_corner = wedge(j) != 0;
    if (beta.sign() != 0) {
      const SingularKind kind = has_corner ? SingularKind::wedge_and_jump : SingularKind::friction_jump;
      result.push_back({coordinate(j), kind, beta, intensity(j), constant(j)});
    } else if (has_corner) {
      result.push_back({coordinate(j), SingularKind::wedge, std::nullopt, intensity(j), constant(j)});
    }
  }
  return result;
}

template <Real R>
Estimate<R> RiemannHilbertSolution<R>::load_on(std::size_t segment) const {
  if (!form_->changes_polynomial(segment) && !form_->changes_polynomial(segment + 1)) return form_->load_on(segment);
  return tanh_sinh::panel_integral(panel_density(*form_, segment));
}

template <Real R>
Resultants<R> RiemannHilbertSolution<R>::resultants() const {
  using std::abs;
  const R unit = to_real<R>(reduced_.frame().unit);
  std::vector<Estimate<R>> loads(problem_.friction().values().size());
  for (std::size_t k = 0; k < contact_set().segments(); ++k) {
    if (!contact_set().in_contact(k)) continue;
    const Estimate<R> load = load_on(k);
    const R half = contact_set().length(k) / 2;
    const R ends = 2 * relative_end_error({static_cast<std::ptrdiff_t>(k), {contact_set().x(k) + half, half, half}});
    loads[form_->friction_at(k)] += -unit * load.widened(ends);
  }
  Resultants<R> result = resultants_of(loads, problem_.friction().values());
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
  EstimatedError<R> worst{max(R(found_->end_error / contact_set().span_length()), epsilon<R>()), R(0), R(0)};
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

template class RiemannHilbertSolution<double>;
template class RiemannHilbertSolution<Real50>;
template class RiemannHilbertSolution<Real100>;

}  // namespace steadyslide::numeric
