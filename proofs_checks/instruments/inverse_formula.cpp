#include "proofs_checks/instruments/inverse_formula.hpp"

#include <algorithm>

#include "numeric/number/polynomial.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// (1+x)^rear (1-x)^front smooth(x).
template <class R>
numeric::PanelDensity<R> on_interval(const Exponent& rear, const Exponent& front, std::vector<R> smooth) {
  return {{R(-1), R(1), R(2)},
          numeric::Power<R>::of(rear),
          numeric::Power<R>::of(front),
          [p = std::move(smooth)](const numeric::Node<R>& node) { return numeric::value_of(p, node.x); }};
}

/// c_n of (1+w)^p (1-w)^q = sum c_n w^n.
template <class R>
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

/// Coefficients of 1, z, ... of z (sum p_k z^k) (sum c_n z^-n).
template <class R>
std::vector<R> polynomial_part(const std::vector<R>& p, const std::vector<R>& c) {
  std::vector<R> result(p.size() + 1, R(0));
  for (std::size_t k = 0; k < p.size(); ++k) {
    for (std::size_t n = 0; n <= k + 1; ++n) result[k + 1 - n] += p[k] * c[n];
  }
  return result;
}

}  // namespace

InverseFormula InverseFormula::of(const Rational& s) {
  const Rational share = 1 / (1 + s * s);
  const Exponent alpha = Exponent::angle(s);
  return {numeric::to_real<Number>(s * share), numeric::to_real<Number>(share), -(half + alpha), -(half - alpha)};
}

template <class R>
InverseByQuadrature<R>::InverseByQuadrature(const InverseFormula& formula, const Polynomial& slope)
    : local_(formula.local),
      integral_(formula.integral),
      slope_(numeric::coefficients_of<R>(slope)),
      weight_(on_interval<R>(formula.rear, formula.front, {R(1)})),
      grid_({on_interval<R>(-formula.rear, -formula.front, slope_)}) {}

template <class R>
double InverseByQuadrature<R>::difference(const numeric::PanelPoint<R>& at, const R& hilbert, const R& expected) const {
  using std::abs, std::max;
  const R local = local_ * numeric::value_of(slope_, at.node.x);
  const R integral = integral_ * weight_(at.node) * hilbert;
  const R size = max({R(abs(local)), R(abs(integral)), R(abs(expected))});
  return static_cast<double>(R(abs(local - integral - expected) / size));
}

template <class R>
double InverseByQuadrature<R>::difference(const numeric::PanelPoint<R>& at, const R& expected) const {
  return difference(at, grid_.hilbert(at), expected);
}

template <class R>
double InverseByQuadrature<R>::difference_by_tanh_sinh(const numeric::PanelPoint<R>& at, const R& expected) const {
  return difference(at, numeric::tanh_sinh::hilbert<R>(grid_.density(), at).value, expected);
}

template <class R>
JacobiTraction<R> inverse_without_integral(const Rational& s, const Polynomial& slope) {
  const Exponent alpha = Exponent::angle(s);
  const std::vector<R> u = numeric::coefficients_of<R>(slope);
  const std::vector<R> series =
      binomial_product<R>(numeric::to_real<R>(half + alpha), numeric::to_real<R>(half - alpha), u.size() + 2);
  std::vector<R> q = polynomial_part(u, series);
  for (R& coefficient : q) coefficient *= numeric::cos_pi_alpha<R>(s);
  return {numeric::Power<R>::of(-(half + alpha)), numeric::Power<R>::of(-(half - alpha)), std::move(q)};
}

#define STEADYSLIDE_INSTANTIATE(R)       \
  template class InverseByQuadrature<R>; \
  template JacobiTraction<R> inverse_without_integral(const Rational&, const Polynomial&);
STEADYSLIDE_INSTANTIATE(double)
STEADYSLIDE_INSTANTIATE(numeric::Real50)
STEADYSLIDE_INSTANTIATE(numeric::Real100)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
