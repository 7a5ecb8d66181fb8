#include "proofs_checks/instruments/tractions/jacobi_traction.hpp"

#include <boost/math/special_functions/chebyshev.hpp>

#include "numeric/quadrature/jacobi_rule.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::Power;

/// Returns int_{-1}^1 (1+x)^left (1-x)^right f(x) dx, exact if f is a polynomial of degree below 2 nodes.
template <class R, class F>
R gauss_jacobi(const Power<R>& left, const Power<R>& right, int nodes, const F& f) {
  using std::pow;
  const numeric::UnitRule<R> rule = numeric::jacobi_rule<R>(left, right, nodes);
  R sum = 0;
  for (std::size_t i = 0; i < rule.size(); ++i) sum += rule.weights[i] * f(R(2 * rule.from_left[i] - 1));
  return sum * pow(R(2), R(left.value + right.plus_one));
}

template <class R>
Power<R> raised(const Power<R>& p) {
  return {p.plus_one - R(1) / 2, p.plus_one + R(1) / 2};
}

/// Returns v for t_hat = x^m, by partial integration. int x^m log|x-y| dx is (x^{m+1} - y^{m+1}) log|x-y|/(m+1) at the
/// ends minus the integral of (x^{m+1} - y^{m+1})/((m+1) (x-y)). The latter is a polynomial, because
/// x^{m+1} - y^{m+1} = (x-y) sum_j x^j y^{m-j}.
template <class R>
R potential_of_power(const R& s, int m, const Node<R>& node) {
  using std::log;
  const R& y = node.x;
  R at_right = 0;
  R at_left = 0;
  R rest = 0;
  R power = 1;  // y^{m-j}
  for (int j = m; j >= 0; --j) {
    at_right += power;
    at_left += j % 2 == 0 ? power : R(-power);
    if (j % 2 == 0) rest += 2 * power / (j + 1);
    power *= y;
  }
  // Now power = y^{m+1}. The factors (1 - y) and (-1 - y) come from the distances.
  const R logarithm =
      (node.from_right * at_right * log(node.from_right) + node.from_left * at_left * log(node.from_left) - rest) /
      (m + 1);
  const R sign = (R(m % 2 == 0 ? 0 : 2) - 2 * power) / (m + 1);
  return -logarithm / numeric::pi<R>() + s / 2 * sign;
}

}  // namespace

template <class R>
PanelDensity<R> density_of(const JacobiTraction<R>& t) {
  return {{R(-1), R(1), R(2)}, t.left, t.right, [p = t.factor](const Node<R>& node) { return value_of(p, node.x); }};
}

template <class R>
R integral(const JacobiTraction<R>& t) {
  return tanh_sinh::panel_integral<R>(density_of(t)).value;
}

template <class R>
R form_with_chebyshev(const JacobiTraction<R>& t, const R& s, int k) {
  const int nodes = static_cast<int>(t.factor.size()) + k;
  const auto degree = static_cast<unsigned>(k);
  const R even = gauss_jacobi<R>(t.left, t.right, nodes, [&](const R& x) {
    return R(boost::math::chebyshev_t(degree, x) * value_of(t.factor, x));
  });
  const R odd = gauss_jacobi<R>(raised(t.left), raised(t.right), nodes, [&](const R& x) {
    return R(boost::math::chebyshev_u(degree - 1, x) * value_of(t.factor, x));
  });
  return (even + s * odd) / k;
}

template <class R>
R form_with_power(const JacobiTraction<R>& t, const R& s, int m) {
  PanelDensity<R> density = density_of(t);
  density.smooth = [smooth = density.smooth, s, m](const Node<R>& node) {
    return R(smooth(node) * potential_of_power(s, m, node));
  };
  return tanh_sinh::panel_integral<R>(density).value;
}

#define STEADYSLIDE_INSTANTIATE(R)                                         \
  template PanelDensity<R> density_of(const JacobiTraction<R>&);           \
  template R integral(const JacobiTraction<R>&);                           \
  template R form_with_chebyshev(const JacobiTraction<R>&, const R&, int); \
  template R form_with_power(const JacobiTraction<R>&, const R&, int);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
