#include "numeric/riemann_hilbert_form.hpp"

#include <cmath>

#include "numeric/polynomial_roots.hpp"
#include "numeric/second_kind.hpp"

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

template <Real R>
SurfacePoint<R> point_in(const ContactSet<R>& set, std::size_t segment, const R& from_left, const R& from_right) {
  const R x = from_left < from_right ? R(set.x(segment) + from_left) : R(set.x(segment + 1) - from_right);
  return {static_cast<std::ptrdiff_t>(segment), {x, from_left, from_right}};
}

/// Subtracts term x^j from entry j.
template <Real R>
void subtract_powers(std::vector<R>& moments, R term, const R& x) {
  for (R& m : moments) {
    m -= term;
    term *= x;
  }
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
void RiemannHilbertForm<R>::expand_at_infinity() {
  const int S = degree_;
  const int g = problem_->highest_degree();
  const auto count = static_cast<std::size_t>(std::max({g + 2, g - S, S + 1, 2})) + 1;
  // log Y = S log z - sum_k sigma_k z^-k/k, sigma_k the power sums of the singular points.
  std::vector<R> sigma(count, R(0));
  for (std::size_t j = 0; j < set_.points().size(); ++j) {
    const R& p = weight_.powers()[j].value;
    if (p == 0) continue;
    R term = p;
    for (std::size_t k = 1; k < count; ++k) {
      term *= set_.x(j);
      sigma[k] += term;
    }
  }
  series_.assign(count, R(0));
  inverse_series_.assign(count, R(0));
  series_[0] = inverse_series_[0] = 1;
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = 1; k <= i; ++k) {
      series_[i] -= sigma[k] * series_[i - k];
      inverse_series_[i] += sigma[k] * inverse_series_[i - k];
    }
    series_[i] /= static_cast<double>(i);
    inverse_series_[i] /= static_cast<double>(i);
  }
}

template <Real R>
const std::vector<R>& RiemannHilbertForm<R>::polynomial(std::size_t slope) const {
  std::vector<R>& result = polynomials_[slope];
  if (!result.empty()) return result;
  std::vector<R> g = problem_->slopes()[slope];
  if (g.empty()) g.push_back(R(0));
  g[0] += tilt_;
  const int top = std::max({static_cast<int>(g.size()) - 1 - degree_, static_cast<int>(q_.size()) - 1, 0});
  result.assign(static_cast<std::size_t>(top) + 1, R(0));
  for (int j = 0; j <= top; ++j) {
    for (int l = std::max(j + degree_, 0); l < static_cast<int>(g.size()); ++l) {
      result[static_cast<std::size_t>(j)] +=
          g[static_cast<std::size_t>(l)] * inverse_series_[static_cast<std::size_t>(l - degree_ - j)];
    }
  }
  for (std::size_t j = 0; j < q_.size(); ++j) result[j] -= q_[j] / pi<R>();
  return result;
}

template <Real R>
R RiemannHilbertForm<R>::tilt_polynomial(const R& x) const {
  R value = 0;
  for (int j = -degree_; j >= 0; --j) value = value * x + inverse_series_[static_cast<std::size_t>(-degree_ - j)];
  return value;
}

template <Real R>
R RiemannHilbertForm<R>::moment_of_load() const {
  // u'/c = -(1/pi) (int t/z + int xi t/z^2 + ...), and it is Y (m_0/z + ... + q/pi).
  const auto count = static_cast<std::size_t>(std::max(degree_ + 2, 0));
  const std::vector<R> m = moments(count);
  R sum = 0;
  for (std::size_t j = 0; j < count; ++j) sum += m[j] * series_[count - 1 - j];
  for (std::size_t l = 0; l < q_.size(); ++l) {
    const int index = degree_ + 2 + static_cast<int>(l);
    if (index >= 0) sum += q_[l] / pi<R>() * series_[static_cast<std::size_t>(index)];
  }
  return sum * pi<R>();
}

template <Real R>
R RiemannHilbertForm<R>::tilt_moment(std::size_t j) const {
  const int index = 1 + static_cast<int>(j) - degree_;
  return index < 0 ? R(0) : inverse_series_[static_cast<std::size_t>(index)];
}

template <Real R>
std::vector<R> RiemannHilbertForm<R>::moments(std::size_t count) const {
  std::vector<R> result(count, R(0));
  if (set_.components() > 1) {
    // -(1/pi) int h xi^j, h = eps cos(pi alpha) (g + tilt)/|Y|: the expansion at infinity would be a small difference
    // of large terms where the components are small beside their distances.
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const R& x = nodes_[i].node.x;
      const std::size_t own = slope_at(static_cast<std::size_t>(nodes_[i].segment));
      subtract_powers(result, R(node_weights_[i] * (problem_->slope(own, x) + tilt_) / pi<R>()), x);
    }
    return result;
  }
  // One component: any k will do, and the polynomial's part is exact. The one of the longest segment is the smallest
  // there.
  std::size_t longest = set_.all(ContactSet<R>::Kind::begins).front();
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) {
    if (set_.in_contact(segment) && set_.length(segment) > set_.length(longest)) longest = segment;
  }
  const std::size_t k = slope_at(longest);
  const std::vector<R>& g = problem_->slopes()[k];
  for (std::size_t j = 0; j < count; ++j) {
    result[j] = tilt_ * tilt_moment(j);
    for (std::size_t l = 0; l < g.size(); ++l) {
      const int index = static_cast<int>(l) - degree_ + 1 + static_cast<int>(j);
      if (index >= 0) result[j] += g[l] * inverse_series_[static_cast<std::size_t>(index)];
    }
  }
  if (!panels_.empty()) {
    const std::vector<R>& f = density(k);
    for (std::size_t i = 0; i < f.size(); ++i) subtract_powers(result, R(f[i] / pi<R>()), nodes_[i].node.x);
  }
  return result;
}

template <Real R>
int RiemannHilbertForm<R>::nodes_per_panel() const {
  // Bernstein's ellipse through a pole at half a panel's length, or a branch point at a whole one, has the parameter
  // 2 + sqrt 3 or more; half a node more for every degree of the polynomial.
  using std::log, std::sqrt;
  static const int geometric = static_cast<int>(-log(epsilon<R>()) / (2 * log(2 + sqrt(R(3))))) + 2;
  return geometric + (problem_->highest_degree() + 1) / 2;
}

template <Real R>
bool RiemannHilbertForm<R>::is_singular(std::size_t j, bool gap) const {
  if (weight_.powers()[j].value != 0) return true;
  // B_k is singular wherever the contact changes its polynomial.
  return gap && j > 0 && j < set_.segments() && (set_.in_contact(j) || set_.in_contact(j - 1));
}

template <Real R>
Surroundings<R> RiemannHilbertForm<R>::surroundings(std::size_t segment, bool gap) const {
  Surroundings<R> result{is_singular(segment, gap), is_singular(segment + 1, gap), infinity<R>(), infinity<R>()};
  R distance = 0;
  for (std::size_t j = segment; j-- > 0;) {
    distance += set_.length(j);
    if (!is_singular(j, gap)) continue;
    result.beyond_left = distance;
    break;
  }
  distance = 0;
  for (std::size_t j = segment + 2; j < set_.points().size(); ++j) {
    distance += set_.length(j - 1);
    if (!is_singular(j, gap)) continue;
    result.beyond_right = distance;
    break;
  }
  return result;
}

template <Real R>
SurfacePoint<R> RiemannHilbertForm<R>::Part::node(const ContactSet<R>& set, std::size_t i) const {
  const bool mirrored = singular_end == Side::right;
  const R left = from_left + length * (mirrored ? rule->from_right[i] : rule->from_left[i]);
  const R right = from_right + length * (mirrored ? rule->from_left[i] : rule->from_right[i]);
  return point_in(set, segment, left, right);
}

template <Real R>
R RiemannHilbertForm<R>::Part::node_weight(std::size_t i) const {
  using std::pow;
  const R w = length * rule->weights[i];
  return power.value == 0 ? w : R(w / pow(rule->from_left[i], power.value));
}

template <Real R>
template <class PowerOf>
std::vector<typename RiemannHilbertForm<R>::Part> RiemannHilbertForm<R>::parts(std::size_t segment,
                                                                               const Stretch& stretch,
                                                                               Surroundings<R> around, int nodes,
                                                                               const PowerOf& power_of) const {
  if (stretch.from_left > 0) {
    around.beyond_left = around.left_singular ? stretch.from_left : R(stretch.from_left + around.beyond_left);
    around.left_singular = false;
  }
  if (stretch.from_right > 0) {
    around.beyond_right = around.right_singular ? stretch.from_right : R(stretch.from_right + around.beyond_right);
    around.right_singular = false;
  }
  std::vector<Part> result;
  for (const GradedPanel<R>& panel : graded_panels(stretch.length, around)) {
    Power<R> power{R(0), R(1)};
    if (panel.singular_end) power = power_of(*panel.singular_end == Side::left ? segment : segment + 1);
    result.push_back({segment, stretch.from_left + panel.from_left, stretch.from_right + panel.from_right, panel.length,
                      panel.singular_end, power, &rules_->get(power, {R(0), R(1)}, nodes)});
  }
  return result;
}

template <Real R>
void RiemannHilbertForm<R>::make_panels() {
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) {
    first_panel_.push_back(panels_.size());
    if (!set_.in_contact(segment)) continue;
    const R amplitude = sign(static_cast<std::ptrdiff_t>(segment)) * problem_->cos_alpha(friction_at(segment));
    const auto power_of = [this](std::size_t j) {
      const R& p = weight_.powers()[j].value;
      return Power<R>{R(-p), R(1 - p)};
    };
    for (const Part& part : parts(segment, whole(segment), surroundings(segment, false), nodes_per_panel(), power_of)) {
      panels_.push_back({part, nodes_.size()});
      for (std::size_t i = 0; i < part.rule->size(); ++i) {
        nodes_.push_back(part.node(set_, i));
        node_weights_.push_back(amplitude * part.node_weight(i) / modulus(nodes_.back()));
      }
    }
  }
  first_panel_.push_back(panels_.size());
}

template <Real R>
const std::vector<R>& RiemannHilbertForm<R>::density(std::size_t slope) const {
  std::vector<R>& result = densities_[slope];
  if (!result.empty() || nodes_.empty()) return result;
  result.reserve(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::size_t own = slope_at(static_cast<std::size_t>(nodes_[i].segment));
    const R& x = nodes_[i].node.x;
    result.push_back(own == slope ? R(0) : R(node_weights_[i] * (problem_->slope(own, x) - problem_->slope(slope, x))));
  }
  return result;
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
  const std::size_t segment = side == Side::left ? j - 1 : j;
  const R& length = set_.length(segment);
  const SurfacePoint<R> at{static_cast<std::ptrdiff_t>(segment),
                           {set_.x(j), side == Side::left ? length : R(0), side == Side::left ? R(0) : length}};
  return bracket(slope_at(segment), at);
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::traction(const SurfacePoint<R>& at) const {
  using std::abs;
  if (at.segment < 0 || at.segment >= static_cast<std::ptrdiff_t>(set_.segments())) return {};
  const auto segment = static_cast<std::size_t>(at.segment);
  if (!set_.in_contact(segment)) return {};
  const R factor = sign(at.segment) * problem_->cos_alpha(friction_at(segment)) * modulus(at);
  const Estimate<R> b = bracket(slope_at(segment), at);
  const R relative = weight_.relative_error(segment, at.node, R(0));
  return {factor * b.value, abs(factor) * (b.error + relative * abs(b.value))};
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::load_on(std::size_t segment) const {
  using std::abs;
  const R amplitude = sign(static_cast<std::ptrdiff_t>(segment)) * problem_->cos_alpha(friction_at(segment));
  Estimate<R> sum;
  const auto power_of = [this](std::size_t j) { return weight_.powers()[j]; };
  for (const Part& part : parts(segment, whole(segment), surroundings(segment, true),
                                nodes_per_panel() + std::max(-degree_, 0), power_of)) {
    for (std::size_t i = 0; i < part.rule->size(); ++i) {
      const SurfacePoint<R> at = part.node(set_, i);
      const R w = part.node_weight(i) * amplitude * modulus(at);
      const Estimate<R> b = bracket(slope_at(segment), at);
      sum.value += w * b.value;
      sum.error += abs(w) * (b.error + 8 * epsilon<R>() * abs(b.value));
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
  const R rounding = 4 * epsilon<R>() * abs(profile);
  if (at.segment == static_cast<std::ptrdiff_t>(segment) && set_.in_contact(segment)) return {profile, rounding};
  const R y = sign(at.segment) * modulus(at);
  const Estimate<R> b = bracket(slope_at(segment), at);
  return {profile - y * b.value, rounding + abs(y) * (b.error + 16 * epsilon<R>() * abs(b.value))};
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

template <Real R>
std::size_t RiemannHilbertForm<R>::slope_for_gap(std::size_t segment, bool left_half) const {
  // Next to an end at a break, B_k is smooth for the k of the contact.
  const bool left = set_.point(segment).is_end();
  const bool right = set_.point(segment + 1).is_end();
  if (left && (left_half || !right)) return slope_at(segment - 1);
  if (right) return slope_at(segment + 1);
  return slope_at(segment);
}

template <Real R>
bool RiemannHilbertForm<R>::changes_slope(std::size_t segment) const {
  return slope_for_gap(segment, true) != slope_for_gap(segment, false);
}

template <Real R>
void RiemannHilbertForm<R>::add_gap_nodes(std::size_t segment, const Stretch& stretch,
                                          std::vector<GapNode>& nodes) const {
  const R middle = set_.length(segment) / 2;
  const bool right_half = stretch.from_left >= middle;
  if (!changes_slope(segment) || right_half || stretch.from_right >= middle) {
    add_gap_nodes(segment, stretch, slope_for_gap(segment, !right_half), nodes);
    return;
  }
  add_gap_nodes(segment, {stretch.from_left, R(middle - stretch.from_left), middle}, slope_for_gap(segment, true),
                nodes);
  add_gap_nodes(segment, {middle, R(middle - stretch.from_right), stretch.from_right}, slope_for_gap(segment, false),
                nodes);
}

template <Real R>
void RiemannHilbertForm<R>::add_gap_nodes(std::size_t segment, const Stretch& stretch, std::size_t slope,
                                          std::vector<GapNode>& nodes) const {
  const auto power_of = [this](std::size_t j) {
    const Power<R>& p = weight_.powers()[j];
    return set_.point(j).vanishes ? Power<R>{R(p.value - 1), p.value} : p;
  };
  for (const Part& part :
       parts(segment, stretch, surroundings(segment, true), nodes_per_panel() + std::max(-degree_, 0), power_of)) {
    for (std::size_t i = 0; i < part.rule->size(); ++i) {
      const SurfacePoint<R> at = part.node(set_, i);
      nodes.push_back({at, slope, part.node_weight(i), R(sign(at.segment) * modulus(at))});
    }
  }
}

template <Real R>
R RiemannHilbertForm<R>::slope_difference(std::size_t segment, const R& from, const R& length) const {
  // The nodes change their k in the middle of a segment that has contact at both ends.
  const std::size_t own = slope_at(segment);
  const R middle = set_.length(segment) / 2;
  const R end = from + length;
  R sum = 0;
  const auto add = [&](std::size_t k, const R& a, const R& b) {
    if (k == own || a >= b) return;
    const R left = point_in(set_, segment, a, R(set_.length(segment) - a)).node.x;
    const R right = point_in(set_, segment, b, R(set_.length(segment) - b)).node.x;
    sum += problem_->rise(own, left, right) - problem_->rise(k, left, right);
  };
  add(slope_for_gap(segment, true), from, std::min(end, middle));
  add(slope_for_gap(segment, false), std::max(from, middle), end);
  return sum;
}

template <Real R>
std::vector<typename RiemannHilbertForm<R>::GapNode> RiemannHilbertForm<R>::gap_rule(std::size_t j) const {
  std::vector<GapNode> nodes;
  for (std::size_t k = j; k < set_.segments() && !set_.in_contact(k); ++k) {
    add_gap_nodes(k, whole(k), nodes);
  }
  return nodes;
}

template <Real R>
R RiemannHilbertForm<R>::rate(const GapNode& node) const {
  return node.y * bracket(node.slope, node.at).value;
}

template <Real R>
R RiemannHilbertForm<R>::closure(std::size_t j, const std::vector<GapNode>& rule) const {
  R sum = 0;
  std::size_t k = j;
  for (; k < set_.segments() && !set_.in_contact(k); ++k) {
    if (set_.point(k).anchor) sum += problem_->anchors()[*set_.point(k).anchor].step;
    sum += slope_difference(k, R(0), set_.length(k));
  }
  if (set_.point(k).anchor) sum += problem_->anchors()[*set_.point(k).anchor].step;
  for (const GapNode& node : rule) sum += node.weight * rate(node);
  return sum;
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::opening(std::size_t j, const SurfacePoint<R>& at) const {
  using std::abs;
  const bool rightwards = static_cast<std::ptrdiff_t>(j) <= at.segment;
  std::vector<GapNode> nodes;
  R sum = 0;
  R size = 0;
  const auto add_step = [&](std::size_t point) {
    if (!set_.point(point).anchor) return;
    const R& step = problem_->anchors()[*set_.point(point).anchor].step;
    sum += step;
    size += abs(step);
  };
  const auto segment = static_cast<std::size_t>(at.segment);
  if (rightwards) {
    for (std::size_t k = j; k < segment; ++k) {
      add_step(k);
      add_gap_nodes(k, whole(k), nodes);
      sum += slope_difference(k, R(0), set_.length(k));
    }
    add_step(segment);
    add_gap_nodes(segment, {R(0), at.node.from_left, at.node.from_right}, nodes);
    sum += slope_difference(segment, R(0), at.node.from_left);
  } else {
    for (std::size_t k = j; k-- > segment + 1;) {
      add_step(k + 1);
      add_gap_nodes(k, whole(k), nodes);
      sum += slope_difference(k, R(0), set_.length(k));
    }
    add_step(segment + 1);
    add_gap_nodes(segment, {at.node.from_left, at.node.from_right, R(0)}, nodes);
    sum += slope_difference(segment, at.node.from_left, at.node.from_right);
  }
  for (const GapNode& node : nodes) {
    const Estimate<R> b = bracket(node.slope, node.at);
    sum += node.weight * node.y * b.value;
    size += abs(node.weight * node.y) * (abs(b.value) + b.error / epsilon<R>());
  }
  return {rightwards ? sum : R(-sum), 4 * epsilon<R>() * size};
}

template <Real R>
std::vector<SurfacePoint<R>> RiemannHilbertForm<R>::extremes(std::size_t segment) const {
  std::vector<double> g;
  for (const R& c : problem_->slopes()[slope_at(segment)]) g.push_back(static_cast<double>(c));
  if (g.empty()) return {};
  g[0] += static_cast<double>(tilt_);
  std::vector<SurfacePoint<R>> result;
  const R& left = set_.x(segment);
  const R& right = set_.x(segment + 1);
  for (const double x : sign_changes(g, static_cast<double>(left), static_cast<double>(right))) {
    if (!(R(x) > left && R(x) < right)) continue;
    result.push_back({static_cast<std::ptrdiff_t>(segment), {R(x), R(x - left), R(right - x)}});
  }
  return result;
}

template <Real R>
R RiemannHilbertForm<R>::profile_rise(std::size_t j, const SurfacePoint<R>& at) const {
  const auto segment = static_cast<std::size_t>(at.segment);
  const bool rightwards = j <= segment;
  const auto step = [&](std::size_t point) {
    return set_.point(point).anchor ? problem_->anchors()[*set_.point(point).anchor].step : R(0);
  };
  R sum = tilt_ * distance(at, j);
  if (rightwards) {
    for (std::size_t k = j; k < segment; ++k) {
      sum += step(k) + problem_->rise(slope_at(k), set_.x(k), set_.x(k + 1));
    }
    return sum + step(segment) + problem_->rise(slope_at(segment), set_.x(segment), at.node.x);
  }
  for (std::size_t k = j; k-- > segment + 1;) {
    sum -= step(k + 1) + problem_->rise(slope_at(k), set_.x(k), set_.x(k + 1));
  }
  return sum - step(segment + 1) - problem_->rise(slope_at(segment), at.node.x, set_.x(segment + 1));
}

template class RiemannHilbertForm<double>;
template class RiemannHilbertForm<Real50>;
template class RiemannHilbertForm<Real100>;

}  // namespace steadyslide::numeric
