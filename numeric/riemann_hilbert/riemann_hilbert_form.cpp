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
  const bool has_pivots = !y_->pivots().empty();
  for (const std::vector<R>& g : problem.slopes()) {
    polynomials_.push_back(polynomial_of(expansion_, g, tilt_, has_pivots ? std::vector<R>() : q_));
  }
  for (std::size_t i = 0; i < y_->pivots().size(); ++i) {
    if (y_->pivots()[i].order < 0) poles_.push_back(i);
  }
  if (!poles_.empty()) load_without_poles_ = quadrature_.moments(tilt_, 1).front();
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::pivoted_polynomial(std::size_t slope, const SurfacePoint<R>& at) const {
  using std::abs;
  const std::size_t i = y_->component_at(at);
  const auto& [pivot, order] = y_->pivots()[i];
  const std::vector<R>& p = polynomials_[slope];
  const R& e = set().x(pivot);
  Estimate<R> result{R(0), R(0)};
  const auto add = [&result](const R& term) {
    result.value += term;
    result.error += abs(term);
  };
  if (order > 0) {
    // (p(x) - p(e))/(x - e)
    std::vector<R> quotient(p.size() - 1);
    R carry = 0;
    for (std::size_t k = p.size(); k-- > 1;) quotient[k - 1] = carry = carry * e + p[k];
    result = horner(quotient, at.node.x);
  } else {
    result = horner(p, at.node.x);
  }
  const R d = order != 0 ? y_->distance(at, pivot) : R(1);
  if (order < 0) {
    result.value *= d;
    result.error *= abs(d);
    add(expansion_.moment(problem().slopes()[slope], tilt_, 0));
    add(-load_without_poles_);
  }
  for (const std::size_t j : poles_) {
    const std::size_t pole = y_->pivots()[j].point;
    if (j == i) {
      add(-q_[j] / pi<R>());
      continue;
    }
    const R term = -q_[j] / (pi<R>() * y_->distance(at, pole));
    add(order == 0 ? term : order < 0 ? R(term * d) : R(-term / (e - set().x(pole))));
  }
  return result;
}

template <Real R>
const R& RiemannHilbertForm<R>::pivot_moment(std::size_t component) const {
  if (pivot_moments_.empty()) pivot_moments_.assign(y_->pivots().size(), infinity<R>());
  R& result = pivot_moments_[component];
  if (result == infinity<R>()) {
    result = 0;
    if (y_->pivots()[component].order > 0) {
      result = quadrature_.pivot_moment(component, tilt_);
      const R& e = set().x(y_->pivots()[component].point);
      for (const std::size_t j : poles_) result -= q_[j] / (pi<R>() * (e - set().x(y_->pivots()[j].point)));
    }
  }
  return result;
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::regular_factor(std::size_t slope, const SurfacePoint<R>& at) const {
  const Estimate<R> regular =
      y_->pivots().empty() ? horner(polynomials_[slope], at.node.x) : pivoted_polynomial(slope, at);
  const Estimate<R> integral = quadrature_.cauchy(slope, at);
  return {regular.value - integral.value / pi<R>(), 4 * epsilon<R>() * (regular.error + integral.error / pi<R>())};
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::regular_factor_at(std::size_t j, Side side) const {
  const auto factor = [&] {
    return regular_factor(slope_at(side == Side::left ? j - 1 : j), beside(set(), j, side, R(0)));
  };
  if (!set().point(j).is_end() || side != set().contact_side(j)) return factor();
  end_factors_.resize(set().points().size());
  if (!end_factors_[j]) end_factors_[j] = factor();
  return *end_factors_[j];
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
    if (!y_->pivots().empty()) {
      values[i] *= factor * y_->to_pivot(at) * regular_factor(slope_at(segment), at).value;
      continue;
    }
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
  if (set().components() > 1) {
    std::vector<R> result = quadrature_.moments(tilt_, count);
    for (const std::size_t j : poles_) {
      R term = q_[j] / pi<R>();
      for (R& m : result) {
        m += term;
        term *= set().x(y_->pivots()[j].point);
      }
    }
    return result;
  }
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
  if (!y_->pivots().empty()) return sum * pi<R>();
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
