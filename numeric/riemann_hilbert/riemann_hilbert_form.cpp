#include "numeric/riemann_hilbert/riemann_hilbert_form.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/number/polynomial.hpp"

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

/// [(g + tilt)/Y]_poly - q/pi.
template <Real R>
std::vector<R> polynomial_of(const ExpansionAtInfinity<R>& expansion, std::vector<R> g, const R& tilt,
                             const std::vector<R>& q) {
  if (g.empty()) g.push_back(R(0));
  g[0] += tilt;
  std::vector<R> result = expansion.polynomial_part(g);
  if (result.size() < q.size()) result.resize(q.size(), R(0));
  for (std::size_t j = 0; j < q.size(); ++j) result[j] -= q[j] / pi<R>();
  return result;
}

}  // namespace

template <Real R>
RiemannHilbertForm<R>::RiemannHilbertForm(const ReducedProblem<R>& problem, ContactSet<R> set, std::vector<R> q,
                                          const R& tilt, JacobiRules<R>& rules)
    : rules_(&rules),
      y_(std::make_shared<const SignedFundamentalSolution<R>>(problem, std::move(set))),
      q_(std::move(q)),
      tilt_(tilt),
      expansion_(*y_),
      quadrature_(*y_, rules) {
  for (const std::vector<R>& g : problem.slopes()) polynomials_.push_back(polynomial_of(expansion_, g, tilt_, q_));
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::regular_factor(std::size_t slope, const SurfacePoint<R>& at) const {
  const Estimate<R> regular = horner(polynomials_[slope], at.node.x);
  const Estimate<R> integral = quadrature_.cauchy(slope, at);
  return {regular.value - integral.value / pi<R>(), 4 * epsilon<R>() * (regular.error + integral.error / pi<R>())};
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::regular_factor_at(std::size_t j, Side side) const {
  return regular_factor(slope_at(side == Side::left ? j - 1 : j), beside(set(), j, side, R(0)));
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::traction(const SurfacePoint<R>& at) const {
  if (at.segment < 0 || at.segment >= static_cast<std::ptrdiff_t>(set().segments())) return {};
  const auto segment = static_cast<std::size_t>(at.segment);
  if (!set().in_contact(segment)) return {};
  const R factor = y_->traction_factor(segment) * modulus(at);
  return factor *
         regular_factor(slope_at(segment), at).widened(fundamental_solution().relative_error(segment, at.node, R(0)));
}

template <Real R>
void RiemannHilbertForm<R>::tractions(std::size_t segment, std::span<const R> from_left, std::span<const R> from_right,
                                      std::span<R> values) const {
  fundamental_solution().moduli(segment, from_left, from_right, values);
  const R factor = y_->traction_factor(segment);
  const std::vector<R>& polynomial = polynomials_[slope_at(segment)];
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SurfacePoint<R> at = surface_point(set(), segment, from_left[i], from_right[i]);
    R regular = 0;
    for (std::size_t k = polynomial.size(); k-- > 0;) regular = regular * at.node.x + polynomial[k];
    if (!quadrature_.vanishes()) regular -= quadrature_.cauchy(slope_at(segment), at).value / pi<R>();
    values[i] *= factor * regular;
  }
}

template <Real R>
R RiemannHilbertForm<R>::profile_slope(const SurfacePoint<R>& at) const {
  return problem().slope(slope_at(nearest_segment(at)), at.node.x) + tilt_;
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::surface_slope(const SurfacePoint<R>& at) const {
  const std::size_t segment = nearest_segment(at);
  const Estimate<R> rounded = Estimate<R>{profile_slope(at), R(0)}.widened(4 * epsilon<R>());
  if (at.segment == static_cast<std::ptrdiff_t>(segment) && set().in_contact(segment)) return rounded;
  return rounded - y_->value(at) * regular_factor(slope_at(segment), at).widened(16 * epsilon<R>());
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::load_on(std::size_t segment) const {
  const R amplitude = y_->traction_factor(segment);
  Estimate<R> sum;
  for (const JacobiPanel<R>& panel :
       panels(whole_segment(set(), segment), [this](std::size_t j) { return y_->power(j); })) {
    for (std::size_t i = 0; i < panel.rule->size(); ++i) {
      const SurfacePoint<R> at = panel.node(set(), i);
      const R w = panel.node_weight(i) * amplitude * modulus(at);
      sum += w * regular_factor(slope_at(segment), at).widened(8 * epsilon<R>());
    }
  }
  return sum;
}

template <Real R>
std::vector<R> RiemannHilbertForm<R>::moments(std::size_t count) const {
  // The expansion at infinity would be a small difference of large terms where components are small beside their gaps.
  if (set().components() > 1) return quadrature_.moments(tilt_, count);
  // One component: any k will do, and the polynomial's part is exact. That of the longest segment is smallest there.
  std::size_t longest = set().all(ContactSet<R>::Kind::begins).front();
  for (std::size_t segment = 0; segment < set().segments(); ++segment) {
    if (set().in_contact(segment) && set().length(segment) > set().length(longest)) longest = segment;
  }
  const std::size_t k = slope_at(longest);
  std::vector<R> result;
  for (std::size_t j = 0; j < count; ++j) result.push_back(expansion_.moment(problem().slopes()[k], tilt_, j));
  quadrature_.add_difference_moments(k, result);
  return result;
}

template <Real R>
R RiemannHilbertForm<R>::moment_of_load() const {
  // u'/c = -(1/pi) (int t/z + int xi t/z^2 + ...), and it is Y (m_0/z + ... + q/pi).
  const int degree = degree_at_infinity();
  const auto count = static_cast<std::size_t>(std::max(degree + 2, 0));
  const std::vector<R> m = moments(count);
  const std::vector<R>& series = expansion_.series();
  R sum = 0;
  for (std::size_t j = 0; j < count; ++j) sum += m[j] * series[count - 1 - j];
  for (std::size_t l = 0; l < q_.size(); ++l) {
    const int index = degree + 2 + static_cast<int>(l);
    if (index >= 0) sum += q_[l] / pi<R>() * series[static_cast<std::size_t>(index)];
  }
  return sum * pi<R>();
}

template <Real R>
std::vector<SurfacePoint<R>> RiemannHilbertForm<R>::profile_extrema(std::size_t segment) const {
  std::vector<double> g;
  for (const R& c : problem().slopes()[slope_at(segment)]) g.push_back(static_cast<double>(c));
  if (g.empty()) return {};
  g[0] += static_cast<double>(tilt_);
  std::vector<SurfacePoint<R>> result;
  const R& left = set().x(segment);
  const R& right = set().x(segment + 1);
  for (const double x : sign_changes(g, static_cast<double>(left), static_cast<double>(right))) {
    if (!(R(x) > left && R(x) < right)) continue;
    result.push_back({static_cast<std::ptrdiff_t>(segment), {R(x), x - left, right - x}});
  }
  return result;
}

template class RiemannHilbertForm<double>;
template class RiemannHilbertForm<Real50>;
template class RiemannHilbertForm<Real100>;

}  // namespace steadyslide::numeric
