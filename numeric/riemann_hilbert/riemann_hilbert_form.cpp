#include "numeric/riemann_hilbert/riemann_hilbert_form.hpp"

#include <cmath>

#include "numeric/cauchy/second_kind.hpp"

namespace steadyslide::numeric {
namespace {

/// sum_k a_k x^k, and the sum of the sizes of what is added.
template <Real R>
Estimate<R> horner(const std::vector<R>& a, const R& x) {
  using std::abs;
  R value = 0;
  R size = 0;
  const R magnitude = abs(x);
  for (std::size_t k = a.size(); k-- > 0;) {
    value = value * x + a[k];
    size = size * magnitude + abs(a[k]);
  }
  return {value, size};
}

/// What is left of int_0^1 y^a/(y + d) dy as d -> 0 without its singular term: -pi d^a/sin(pi a), or -log(d length) if
/// a = 0.
template <Real R>
R regular_second_kind(const Power<R>& a, const R& length) {
  using std::log;
  return a.value == 0 ? R(log(length)) : R(1 / a.value);
}

}  // namespace

template <Real R>
Power<R> RiemannHilbertForm<R>::power_of(const ReducedProblem<R>& problem, const ContactSet<R>& set, std::size_t j) {
  const auto& point = set.point(j);
  const auto friction = [&](std::size_t segment) { return problem.friction_of(set.interval(segment)); };
  switch (point.kind) {
    case ContactSet<R>::Kind::begins:
      return point.vanishes ? problem.free_power(End::left, friction(j)) : problem.edge_power(End::left, friction(j));
    case ContactSet<R>::Kind::ends:
      return point.vanishes ? problem.free_power(End::right, friction(j - 1))
                            : problem.edge_power(End::right, friction(j - 1));
    default: break;
  }
  const bool inside = j > 0 && j < set.segments() && set.in_contact(j);
  if (!inside || !point.anchor) return {R(0), R(1)};
  return problem.jump_power(*point.anchor);
}

template <Real R>
FundamentalSolution<R> RiemannHilbertForm<R>::make_weight(const ReducedProblem<R>& problem, const ContactSet<R>& set) {
  std::vector<Power<R>> powers;
  powers.reserve(set.points().size());
  for (std::size_t j = 0; j < set.points().size(); ++j) powers.push_back(power_of(problem, set, j));
  return FundamentalSolution<R>(set.panels(), std::move(powers));
}

template <Real R>
RiemannHilbertForm<R>::RiemannHilbertForm(const ReducedProblem<R>& problem, ContactSet<R> set, std::vector<R> q,
                                          const R& tilt, JacobiRules<R>& rules)
    : problem_(&problem),
      rules_(&rules),
      set_(std::move(set)),
      weight_(make_weight(problem, set_)),
      q_(std::move(q)),
      tilt_(tilt) {
  find_signs();
  expand_at_infinity();
  polynomials_.resize(problem.slopes().size());
  densities_.resize(problem.slopes().size());
  if (problem.slopes().size() > 1 || set_.components() > 1) make_panels();
}

template <Real R>
const Exponent& RiemannHilbertForm<R>::exponent(std::size_t j) const {
  const auto& point = set_.point(j);
  if (!point.is_end()) return problem_->jump_exponent(*point.anchor);
  const End end = point.kind == ContactSet<R>::Kind::begins ? End::left : End::right;
  const std::size_t friction = friction_at(end == End::left ? j : j - 1);
  return point.vanishes ? problem_->free_exponent(end, friction) : problem_->edge_exponent(end, friction);
}

template <Real R>
void RiemannHilbertForm<R>::find_signs() {
  const std::size_t n = set_.segments();
  signs_.assign(n + 2, 1);
  int sum = 0;  // of the powers on the right of what is looked at: an integer between components
  for (std::size_t k = n; k-- > 0;) {
    const auto& right = set_.point(k + 1);
    const auto even = [](int i) { return i % 2 == 0; };
    if (!set_.in_contact(k)) {
      if (right.kind == ContactSet<R>::Kind::begins) {
        // A component lies between here and the gap on the right of it: its powers sum to (free ends) - 1.
        std::size_t last = k + 2;
        while (!set_.point(last).is_end()) ++last;
        sum += (right.vanishes ? 1 : 0) + (set_.point(last).vanishes ? 1 : 0) - 1;
      }
      signs_[k + 1] = even(sum) ? 1 : -1;
    } else if (right.kind == ContactSet<R>::Kind::ends) {
      signs_[k + 1] = even(sum) != right.vanishes ? 1 : -1;
    } else {
      signs_[k + 1] = signs_[k + 2];
    }
  }
  if (set_.point(0).kind == ContactSet<R>::Kind::begins) {
    std::size_t last = 1;
    while (!set_.point(last).is_end()) ++last;
    sum += (set_.point(0).vanishes ? 1 : 0) + (set_.point(last).vanishes ? 1 : 0) - 1;
  }
  degree_ = sum;
  signs_[0] = sum % 2 == 0 ? 1 : -1;
}

template <Real R>
R RiemannHilbertForm<R>::modulus(const SurfacePoint<R>& at) const {
  if (at.segment < 0) return weight_.modulus_beyond(Side::left, at.node.from_right);
  if (at.segment >= static_cast<std::ptrdiff_t>(set_.segments())) {
    return weight_.modulus_beyond(Side::right, at.node.from_left);
  }
  return weight_.modulus(static_cast<std::size_t>(at.segment), at.node);
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::panel_cauchy(const ContactPanel& panel, std::size_t slope, const SurfacePoint<R>& at,
                                                const R& between, const std::vector<R>& density) const {
  using std::abs, std::pow;
  const Part& part = panel.part;
  const bool panel_is_right = at.segment < static_cast<std::ptrdiff_t>(part.segment);
  const std::size_t count = part.rule->size();
  const R gap = between + (panel_is_right ? part.from_left : part.from_right);
  R sum = 0;
  R size = 0;
  if (2 * gap >= part.length) {
    for (std::size_t i = panel.first; i < panel.first + count; ++i) {
      const R term = density[i] / (between + (panel_is_right ? nodes_[i].node.from_left : nodes_[i].node.from_right));
      sum += term;
      size += abs(term);
    }
  } else {
    // phi(y) y^a over the unit interval, y from the end that faces the point, where the power sits if there is any:
    // int y^a (phi(y) - phi(-d))/(y + d) + phi(-d) int y^a/(y + d), exactly the function of the second kind.
    const R d = gap / part.length;
    const auto facing = static_cast<std::size_t>(panel_is_right ? part.segment : part.segment + 1);
    const R& p = weight_.powers()[facing].value;
    // At the end itself d^-p/|Y| is known by its limit.
    R phi = gap == 0 ? R(1 / (weight_.amplitude(facing) * pow(part.length, p))) : R(1 / modulus(at));
    if (gap > 0 && p != 0) phi *= pow(d, p);
    phi *= sign(static_cast<std::ptrdiff_t>(part.segment)) * problem_->cos_alpha(friction_at(part.segment)) *
           (problem_->slope(slope_at(part.segment), at.node.x) - problem_->slope(slope, at.node.x));
    const bool mirrored = !part.singular_end && !panel_is_right;
    for (std::size_t i = 0; i < count; ++i) {
      const R& y = mirrored ? part.rule->from_right[i] : part.rule->from_left[i];
      const R term = (density[panel.first + i] / part.length - phi * part.rule->weights[i]) / (y + d);
      sum += term;
      size += abs(term) + abs(phi * part.rule->weights[i]);
    }
    const R rest = phi * (gap == 0 ? regular_second_kind(part.power, part.length) : second_kind::beyond(part.power, d));
    sum += rest;
    size += abs(rest);
  }
  return {panel_is_right ? sum : R(-sum), size};
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::cauchy(std::size_t slope, const SurfacePoint<R>& at) const {
  Estimate<R> total{R(0), R(0)};
  if (panels_.empty()) return total;
  const std::vector<R>& f = density(slope);
  const auto add = [&](std::size_t segment, const R& between) {
    if (!set_.in_contact(segment) || slope_at(segment) == slope) return;
    for (std::size_t k = first_panel_[segment]; k < first_panel_[segment + 1]; ++k) {
      const Estimate<R> part = panel_cauchy(panels_[k], slope, at, between, f);
      total.value += part.value;
      total.error += part.error;
    }
  };
  R between = at.node.from_right;
  for (auto k = static_cast<std::size_t>(at.segment + 1); k < set_.segments(); ++k) {
    add(k, between);
    between += set_.length(k);
  }
  between = at.node.from_left;
  for (std::ptrdiff_t k = at.segment; k-- > 0;) {
    add(static_cast<std::size_t>(k), between);
    between += set_.length(static_cast<std::size_t>(k));
  }
  return total;
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::bracket(std::size_t slope, const SurfacePoint<R>& at) const {
  const Estimate<R> regular = horner(polynomial(slope), at.node.x);
  const Estimate<R> integral = cauchy(slope, at);
  return {regular.value - integral.value / pi<R>(), 4 * epsilon<R>() * (regular.error + integral.error / pi<R>())};
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::bracket_at(std::size_t j, Side side) const {
  return bracket(slope_at(side == Side::left ? j - 1 : j), beside(set_, j, side, R(0)));
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::traction(const SurfacePoint<R>& at) const {
  if (at.segment < 0 || at.segment >= static_cast<std::ptrdiff_t>(set_.segments())) return {};
  const auto segment = static_cast<std::size_t>(at.segment);
  if (!set_.in_contact(segment)) return {};
  const R factor = sign(at.segment) * problem_->cos_alpha(friction_at(segment)) * modulus(at);
  return factor * bracket(slope_at(segment), at).widened(weight_.relative_error(segment, at.node, R(0)));
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::load_on(std::size_t segment) const {
  const R amplitude = sign(static_cast<std::ptrdiff_t>(segment)) * problem_->cos_alpha(friction_at(segment));
  Estimate<R> sum;
  const auto power_of = [this](std::size_t j) { return weight_.powers()[j]; };
  for (const Part& part : parts(segment, whole(segment), surroundings(segment, true),
                                nodes_per_panel() + std::max(-degree_, 0), power_of)) {
    for (std::size_t i = 0; i < part.rule->size(); ++i) {
      const SurfacePoint<R> at = part.node(set_, i);
      const R w = part.node_weight(i) * amplitude * modulus(at);
      sum += w * bracket(slope_at(segment), at).widened(8 * epsilon<R>());
    }
  }
  return sum;
}

template <Real R>
bool RiemannHilbertForm<R>::is_kinked(std::size_t j) const {
  return j > 0 && j < set_.segments() && set_.in_contact(j - 1) && set_.in_contact(j) && slope_at(j - 1) != slope_at(j);
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::surface_slope(const SurfacePoint<R>& at) const {
  using std::abs;
  const std::ptrdiff_t last = static_cast<std::ptrdiff_t>(set_.segments()) - 1;
  const auto segment = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at.segment, 0, last));
  const R profile = problem_->slope(slope_at(segment), at.node.x) + tilt_;
  const Estimate<R> rounded{profile, 4 * epsilon<R>() * abs(profile)};
  if (at.segment == static_cast<std::ptrdiff_t>(segment) && set_.in_contact(segment)) return rounded;
  const R y = sign(at.segment) * modulus(at);
  return rounded - y * bracket(slope_at(segment), at).widened(16 * epsilon<R>());
}

template <Real R>
R RiemannHilbertForm<R>::distance(const SurfacePoint<R>& at, std::size_t j) const {
  const auto point = static_cast<std::ptrdiff_t>(j);
  if (point <= at.segment) {
    R d = at.node.from_left;
    for (std::ptrdiff_t k = point; k < at.segment; ++k) d += set_.length(static_cast<std::size_t>(k));
    return d;
  }
  R d = at.node.from_right;
  for (std::ptrdiff_t k = at.segment + 1; k < point; ++k) d += set_.length(static_cast<std::size_t>(k));
  return -d;
}

template class RiemannHilbertForm<double>;
template class RiemannHilbertForm<Real50>;
template class RiemannHilbertForm<Real100>;

}  // namespace steadyslide::numeric
