#include "proofs_checks/instruments/operators/inverse_operator.hpp"

#include <algorithm>

namespace steadyslide::proofs_checks {
namespace {

/// Returns 1/W at a node of a panel. If `whole` is false, the power of a panel end at -1 or 1 is left out.
template <Real R>
R inverse_weight(const InverseFormula& formula, const SlopePanel<R>& panel, const Node<R>& node, bool whole) {
  using std::pow;
  R value = 1;
  if (whole || panel.left != -1) value *= pow(R(node.from_left + (panel.left + 1)), -to_real<R>(formula.rear));
  const R rest = 1 - (panel.left + panel.length);
  const bool at_end = rest < panel.length * numeric::epsilon<R>() * 16;
  if (whole || !at_end) value *= pow(R(node.from_right + (at_end ? R(0) : rest)), -to_real<R>(formula.front));
  return value;
}

template <Real R>
PiecewiseDensity<R> over_weight(const InverseFormula& formula, const std::vector<SlopePanel<R>>& slope) {
  PiecewiseDensity<R> density;
  for (std::size_t k = 0; k < slope.size(); ++k) {
    const SlopePanel<R>& panel = slope[k];
    // The weight contributes the power at an end of ]-1, 1[, because u' is smooth there.
    const auto left = k == 0 ? numeric::Power<R>::of(-formula.rear) : panel.at_left;
    const auto right = k + 1 == slope.size() ? numeric::Power<R>::of(-formula.front) : panel.at_right;
    density.push_back({{panel.left, R(panel.left + panel.length), panel.length}, left, right, [=](const Node<R>& node) {
                         return R(panel.smooth(node) * inverse_weight(formula, panel, node, false));
                       }});
  }
  return density;
}

/// Returns the coefficients c_n of (1+w)^p (1-w)^q = sum c_n w^n.
template <Real R>
std::vector<R> binomial_product(const R& p, const R& q, std::size_t count) {
  std::vector<R> a{R(1)};
  std::vector<R> b{R(1)};
  for (std::size_t n = 1; n < count; ++n) {
    const auto k = static_cast<int>(n);
    a.push_back(a.back() * (p - (k - 1)) / k);
    b.push_back(-b.back() * (q - (k - 1)) / k);
  }
  std::vector<R> c(count, R(0));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; i + j < count; ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

}  // namespace

InverseFormula InverseFormula::of(const Rational& s) {
  const Rational share = 1 / (1 + s * s);
  const Exponent alpha = Exponent::angle(s);
  return {to_real<Number>(s * share), to_real<Number>(share), -(half + alpha), -(half - alpha)};
}

template <class R>
double InverseTerms<R>::difference(const R& expected) const {
  using std::abs, std::max;
  return static_cast<double>(R(abs(sum() - expected) / max({R(abs(local)), R(abs(integral)), R(abs(expected))})));
}

template <Real R>
InverseOperator<R>::InverseOperator(const InverseFormula& formula, std::vector<SlopePanel<R>> slope)
    : formula_(formula), slope_(std::move(slope)), grid_(over_weight(formula_, slope_)) {}

template <Real R>
InverseOperator<R>::InverseOperator(const InverseFormula& formula, const Polynomial& slope)
    : InverseOperator(formula,
                      {{R(-1), R(2), {R(0), R(1)}, {R(0), R(1)}, [p = coefficients_of<R>(slope)](const Node<R>& node) {
                          return value_of(p, node.x);
                        }}}) {}

template <Real R>
InverseTerms<R> InverseOperator<R>::terms(const PanelPoint<R>& at, const R& hilbert) const {
  using std::pow;
  const SlopePanel<R>& panel = slope_[at.panel];
  R u = panel.smooth(at.node);
  if (panel.at_left.value != 0) u *= pow(at.node.from_left, panel.at_left.value);
  if (panel.at_right.value != 0) u *= pow(at.node.from_right, panel.at_right.value);
  return {R(formula_.local) * u, R(formula_.integral) * hilbert / inverse_weight(formula_, panel, at.node, true)};
}

template <Real R>
InverseTerms<R> InverseOperator<R>::terms_by_tanh_sinh(const PanelPoint<R>& at) const {
  return terms(at, tanh_sinh::hilbert<R>(grid_.density(), at).value);
}

template <Real R>
JacobiTraction<R> inverse_without_integral(const Rational& s, const Polynomial& slope) {
  const Exponent alpha = Exponent::angle(s);
  const std::vector<R> u = coefficients_of<R>(slope);
  const std::vector<R> series = binomial_product<R>(to_real<R>(half + alpha), to_real<R>(half - alpha), u.size() + 2);
  // The coefficients of 1, z, ... in z (sum u_k z^k) (sum series_n z^-n).
  std::vector<R> q(u.size() + 1, R(0));
  for (std::size_t k = 0; k < u.size(); ++k) {
    for (std::size_t n = 0; n <= k + 1; ++n) q[k + 1 - n] += cos_pi_alpha<R>(s) * u[k] * series[n];
  }
  return {numeric::Power<R>::of(-(half + alpha)), numeric::Power<R>::of(-(half - alpha)), std::move(q)};
}

#define STEADYSLIDE_INSTANTIATE(R)   \
  template struct InverseTerms<R>;   \
  template class InverseOperator<R>; \
  template JacobiTraction<R> inverse_without_integral(const Rational&, const Polynomial&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
