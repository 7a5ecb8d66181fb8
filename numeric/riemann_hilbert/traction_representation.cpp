#include "numeric/riemann_hilbert/traction_representation.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/number/compensated_sum.hpp"
#include "numeric/number/polynomial.hpp"

namespace steadyslide::numeric {
namespace {

/// Returns sum_k a_k x^k, and the sum of the absolute values of the terms; `sizes` belong to the a_k.
template <Real R>
Estimate<R> horner(const std::vector<R>& a, const std::vector<R>& sizes, const R& x) {
  R value = 0;
  R size = 0;
  const R magnitude = abs(x);
  for (std::size_t k = a.size(); k-- > 0;) {
    value = value * x + a[k];
    size = size * magnitude + sizes[k];
  }
  return {value, size};
}

/// Returns [(g + tilt)/Y]_poly - q/pi.
template <Real R>
std::vector<Estimate<R>> polynomial_of(const ExpansionAtInfinity<R>& expansion, std::vector<R> g, const R& tilt,
                                       const std::vector<R>& q) {
  if (g.empty()) g.push_back(R(0));
  g[0] += tilt;
  std::vector<Estimate<R>> result = expansion.polynomial_part(g);
  if (result.size() < q.size()) result.resize(q.size());
  for (std::size_t j = 0; j < q.size(); ++j) {
    result[j] += Estimate<R>{-q[j] / pi<R>(), R(0)}.widened(4 * epsilon<R>());
  }
  return result;
}

}  // namespace

template <Real R>
TractionRepresentation<R>::TractionRepresentation(const RoundedProblem<R>& problem, ContactSet<R> set, std::vector<R> q,
                                                  const R& tilt, JacobiRules<R>& rules)
    : rules_(&rules),
      y_(std::make_shared<const SignedFundamentalSolution<R>>(problem, std::move(set))),
      q_(std::move(q)),
      tilt_(tilt),
      expansion_(*y_),
      quadrature_(*y_, rules) {
  const bool has_pivots = !y_->pivots().empty();
  for (const std::vector<R>& g : problem.slopes()) {
    polynomials_.emplace_back();
    sizes_.emplace_back();
    for (const auto& a : polynomial_of(expansion_, g, tilt_, has_pivots ? std::vector<R>() : q_)) {
      polynomials_.back().push_back(a.value);
      sizes_.back().push_back(std::max(R(abs(a.value)), R(a.error / (4 * epsilon<R>()))));
    }
  }
  for (std::size_t i = 0; i < y_->pivots().size(); ++i) {
    if (y_->pivots()[i].order < 0) poles_.push_back(i);
  }
  if (!poles_.empty()) load_without_poles_ = quadrature_.moments(tilt_, 1).front();
}

template <Real R>
Estimate<R> TractionRepresentation<R>::pivoted_polynomial(std::size_t slope, const SurfacePoint<R>& at) const {
  const std::size_t i = y_->component_at(at);
  const auto& [pivot, order] = y_->pivots()[i];
  const std::vector<R>& p = polynomials_[slope];
  const std::vector<R>& sizes = sizes_[slope];
  const R& e = set().x(pivot);
  Estimate<R> result{R(0), R(0)};
  const auto add = [&result](const R& term) {
    result.value += term;
    result.error += abs(term);
  };
  const auto add_estimate = [&result](const Estimate<R>& term) {
    result.value += term.value;
    result.error += std::max(R(abs(term.value)), R(term.error / (4 * epsilon<R>())));
  };
  if (order > 0) {
    // (p(x) - p(e))/(x - e)
    std::vector<R> quotient(p.size() - 1), quotient_sizes(p.size() - 1);
    R carry = 0, size = 0;
    for (std::size_t k = p.size(); k-- > 1;) {
      quotient[k - 1] = carry = carry * e + p[k];
      quotient_sizes[k - 1] = size = size * abs(e) + sizes[k];
    }
    result = horner(quotient, quotient_sizes, at.node.x);
  } else {
    result = horner(p, sizes, at.node.x);
  }
  const R d = order != 0 ? y_->distance(at, pivot) : R(1);
  if (order < 0) {
    result.value *= d;
    result.error *= abs(d);
    add_estimate(expansion_.moment(problem().slopes()[slope], tilt_, 0));
    add_estimate(-load_without_poles_);
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
const Estimate<R>& TractionRepresentation<R>::pivot_moment(std::size_t component) const {
  const std::lock_guard lock(*making_);
  pivot_moments_.resize(y_->pivots().size());
  std::optional<Estimate<R>>& result = pivot_moments_[component];
  if (!result) {
    result = Estimate<R>{};
    if (y_->pivots()[component].order > 0) {
      result = quadrature_.pivot_moment(component, tilt_);
      const R& e = set().x(y_->pivots()[component].point);
      for (const std::size_t j : poles_) {
        const R term = q_[j] / (pi<R>() * (e - set().x(y_->pivots()[j].point)));
        *result += Estimate<R>{-term, R(0)}.widened(8 * epsilon<R>());
      }
    }
  }
  return *result;
}

template <Real R>
Estimate<R> TractionRepresentation<R>::regular_factor(std::size_t slope, const SurfacePoint<R>& at) const {
  const Estimate<R> regular =
      y_->pivots().empty() ? horner(polynomials_[slope], sizes_[slope], at.node.x) : pivoted_polynomial(slope, at);
  const Estimate<R> integral = quadrature_.cauchy(slope, at);
  return {regular.value - integral.value / pi<R>(), 4 * epsilon<R>() * (regular.error + integral.error / pi<R>())};
}

template <Real R>
R TractionRepresentation<R>::regular_value(std::size_t slope, const SurfacePoint<R>& at) const {
  if (!y_->pivots().empty()) return regular_factor(slope, at).value;
  const R polynomial = value_of(polynomials_[slope], at.node.x);
  return quadrature_.vanishes() ? polynomial : R(polynomial - quadrature_.cauchy(slope, at).value / pi<R>());
}

template <Real R>
bool TractionRepresentation<R>::regular_value_is_constant(std::size_t slope) const {
  const std::vector<R>& p = polynomials_[slope];
  return y_->pivots().empty() && quadrature_.vanishes() &&
         std::all_of(p.begin() + 1, p.end(), [](const R& coefficient) { return coefficient == 0; });
}

template <Real R>
Estimate<R> TractionRepresentation<R>::regular_factor_at(std::size_t j, Side side) const {
  const auto factor = [&] {
    return regular_factor(slope_at(side == Side::left ? j - 1 : j), beside(set(), j, side, R(0)));
  };
  if (!set().point(j).is_end() || side != set().contact_side(j)) return factor();
  const std::lock_guard lock(*making_);
  end_factors_.resize(set().points().size());
  if (!end_factors_[j]) end_factors_[j] = factor();
  return *end_factors_[j];
}

template <Real R>
R TractionRepresentation<R>::error_of_state(const SurfacePoint<R>& at, const StateErrors<R>& errors) const {
  const std::vector<R> distances = y_->distances_of_ends(at);
  const auto& pivots = y_->pivots();
  // The distance between two points, accurate for any length of the gap between them.
  const auto apart = [&](std::size_t i, std::size_t j) {
    const R d = abs(distances[i] - distances[j]);
    if (d > sqrt(epsilon<R>()) * abs(distances[i])) return d;
    return set().sum_of_lengths(std::min(i, j), std::max(i, j), R(0));
  };
  // |f - e|^order. For a component's own pivot f = e, the term is (x - e)^order/(x - e), which has no pole for order 1.
  const auto pivot_factor = [&](std::size_t f, std::size_t component, bool is_pivot) {
    const auto& [pivot, order] = pivots[component];
    if (order == 0) return R(1);
    R d = f == pivot ? R(abs(distances[f])) : apart(f, pivot);
    if (is_pivot) d = std::max(d, R(abs(distances[pivot])));
    return order > 0 ? d : R(1 / d);
  };
  R sum = 0;
  for (const std::size_t f : set().movable()) {
    if (distances[f] == 0) continue;
    R b = regular_factor_at(f, set().contact_side(f)).value;
    if (!pivots.empty()) {
      const std::size_t own = y_->component_of(f);
      const std::size_t here = y_->component_at(at);
      if (own != here) b *= pivot_factor(f, own, false) / pivot_factor(f, here, f == pivots[own].point);
    }
    sum += abs(power(f).value * b) * set().displacement(f, errors.ends) / abs(distances[f]);
  }
  if (errors.polynomial.empty()) return sum;
  if (pivots.empty()) return sum + value_of(errors.polynomial, R(abs(at.node.x)));
  const std::size_t here = y_->component_at(at);
  const auto& [pivot, order] = pivots[here];
  for (std::size_t i = 0; i < poles_.size(); ++i) {
    const std::size_t pole = pivots[poles_[i]].point;
    R factor = 1;  // as in pivoted_polynomial
    if (pole != pivot) {
      if (order != 0) factor = order < 0 ? R(abs(distances[pivot])) : R(1 / apart(pole, pivot));
      factor /= abs(distances[pole]);
    }
    sum += errors.polynomial[i] * factor;
  }
  return sum;
}

template <Real R>
std::vector<JacobiPanel<R>> TractionRepresentation<R>::error_panels(const SegmentPart<R>& part) const {
  // A displacement of an end lowers its power by one.
  const std::function<Power<R>(std::size_t)> power_at = [this](std::size_t j) {
    const Power<R>& p = power(j);
    return set().point(j).is_movable() ? Power<R>{p.value - 1, p.value} : p;
  };
  return jacobi_panels(*y_, part, SmoothFactor::error, power_at, *rules_);
}

template <Real R>
R TractionRepresentation<R>::integral_of_error(const SegmentPart<R>& part,
                                               const std::function<R(const SurfacePoint<R>&)>& error) const {
  R sum = 0;
  for (const JacobiPanel<R>& panel : error_panels(part)) {
    sum += panel.node_weight(0) * error(panel.node(set(), 0));
  }
  return sum;
}

template <Real R>
Estimate<R> TractionRepresentation<R>::traction(const SurfacePoint<R>& at) const {
  if (!in_contact(set(), at)) return {};
  const auto segment = static_cast<std::size_t>(at.segment);
  const R factor = y_->traction_factor(segment) * modulus(at);
  return factor *
         regular_factor(slope_at(segment), at).widened(fundamental_solution().relative_error(segment, at.node, R(0)));
}

template <Real R>
void TractionRepresentation<R>::tractions(std::size_t segment, std::span<const R> from_left,
                                          std::span<const R> from_right, std::span<R> values) const {
  fundamental_solution().moduli(segment, from_left, from_right, values);
  const R factor = y_->traction_factor(segment);
  const bool has_pivots = !y_->pivots().empty();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SurfacePoint<R> at = surface_point(set(), segment, from_left[i], from_right[i]);
    const R regular = factor * regular_value(slope_at(segment), at);
    values[i] *= has_pivots ? R(regular * abs(y_->to_pivot(at))) : regular;
  }
}

template <Real R>
Estimate<R> TractionRepresentation<R>::profile_slope(const SurfacePoint<R>& at) const {
  return problem().slope_estimate(slope_at(nearest_segment(at)), at.node.x) +
         Estimate<R>{tilt_, R(0)}.widened(4 * epsilon<R>());
}

template <Real R>
Estimate<R> TractionRepresentation<R>::surface_slope(const SurfacePoint<R>& at) const {
  const std::size_t segment = nearest_segment(at);
  const Estimate<R> profile = profile_slope(at);
  if (at.segment == static_cast<std::ptrdiff_t>(segment) && set().in_contact(segment)) return profile;
  return profile - y_->value(at) * regular_factor(slope_at(segment), at).widened(16 * epsilon<R>());
}

template <Real R>
Estimate<R> TractionRepresentation<R>::load_on(std::size_t segment) const {
  const R amplitude = y_->traction_factor(segment);
  EstimateSum<R> sum;
  for (const JacobiPanel<R>& panel :
       panels(whole_segment(set(), segment), [this](std::size_t j) { return y_->power(j); })) {
    for (std::size_t i = 0; i < panel.rule->size(); ++i) {
      const SurfacePoint<R> at = panel.node(set(), i);
      const R w = panel.node_weight(i) * amplitude * modulus(at);
      sum.add(w * regular_factor(slope_at(segment), at).widened(8 * epsilon<R>()));
    }
  }
  return sum.value();
}

template <Real R>
std::vector<Estimate<R>> TractionRepresentation<R>::moments(std::size_t count) const {
  // If components are small compared with their gaps, the expansion at infinity would be a small difference of large
  // terms.
  if (set().components() > 1) {
    std::vector<Estimate<R>> result = quadrature_.moments(tilt_, count);
    for (const std::size_t j : poles_) {
      Estimate<R> term = Estimate<R>{q_[j] / pi<R>(), R(0)}.widened(8 * epsilon<R>());
      for (Estimate<R>& m : result) {
        m += term;
        term *= set().x(y_->pivots()[j].point);
      }
    }
    return result;
  }
  // One component: every k gives the same result, and the polynomial part is exact. For the k of the longest segment,
  // the integral is smallest.
  std::size_t longest = set().all(ContactSet<R>::Kind::begins).front();
  for (std::size_t segment = 0; segment < set().segments(); ++segment) {
    if (set().in_contact(segment) && set().length(segment) > set().length(longest)) longest = segment;
  }
  const std::size_t k = slope_at(longest);
  std::vector<Estimate<R>> result = quadrature_.difference_moments(k, count);
  for (std::size_t j = 0; j < count; ++j) result[j] += expansion_.moment(problem().slopes()[k], tilt_, j);
  return result;
}

template <Real R>
Estimate<R> TractionRepresentation<R>::moment_of_load() const {
  // u'/c = -(1/pi) (int t/z + int xi t/z^2 + ...) = Y (m_0/z + ... + q/pi).
  const int degree = degree_at_infinity();
  const auto count = static_cast<std::size_t>(std::max(degree + 2, 0));
  const std::vector<Estimate<R>> m = moments(count);
  const std::vector<R>& series = expansion_.series();
  Estimate<R> sum;
  for (std::size_t j = 0; j < count; ++j) sum += series[count - 1 - j] * m[j].widened(8 * epsilon<R>());
  if (!y_->pivots().empty()) return pi<R>() * sum;
  for (std::size_t l = 0; l < q_.size(); ++l) {
    const int index = degree + 2 + static_cast<int>(l);
    if (index < 0) continue;
    const R term = q_[l] / pi<R>() * series[static_cast<std::size_t>(index)];
    sum += Estimate<R>{term, R(0)}.widened(8 * epsilon<R>());
  }
  return pi<R>() * sum;
}

template <Real R>
std::vector<SurfacePoint<R>> TractionRepresentation<R>::profile_extrema(std::size_t segment) const {
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

STEADYSLIDE_INSTANTIATE_CLASS(TractionRepresentation)

}  // namespace steadyslide::numeric
