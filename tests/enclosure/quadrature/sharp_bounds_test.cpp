// Bounds of quadratures and series, each for a function whose error nearly reaches it.

#include <acb_hypgeom.h>

#include "enclosure/number/ball_polynomial.hpp"
#include "enclosure/number/chebyshev_series.hpp"
#include "enclosure/quadrature/jacobi_polynomial.hpp"
#include "enclosure/quadrature/power_panel.hpp"
#include "enclosure/quadrature/trapezoidal.hpp"
#include "support/enclosure_test.hpp"
#include "support/sharp_bounds.hpp"

namespace steadyslide::sharp_quadratures {

constexpr Bits bits = 300;

double ratio(const Ball& error, const Ball& bound) { return (abs(error) / bound).to_double(); }

Ball beta(const Ball& a, const Ball& b) { return gamma(a) * gamma(b) / gamma(a + b); }

/// Returns max |T_k| on the ellipse rho.
Ball largest_chebyshev(int k, const Ball& rho) { return (power(rho, k) + power(rho, -k)) / 2; }

template <class Nodes, class F>
Ball sum_over(const Nodes& nodes, const F& f) {
  Ball sum(0, bits);
  for (const auto& node : nodes) sum += node.weight * f(node);
  return sum;
}

Ball one(const auto& /*node*/) { return 1; }

/// The rule with n nodes sees T_2n as a constant: T_n^2 = (T_2n + 1)/2 is 0 at Chebyshev's nodes.
double jacobi_remainder() {
  constexpr int n = 7;
  const Ball half(-0.5_r, bits), rho(5, bits);
  const JacobiRule rule(n, half, half, bits);
  Ball sum(0, bits);  // the integral is 0
  for (std::size_t i = 0; i < rule.size(); ++i) {
    sum += rule.weights[i] * chebyshev_polynomial(2 * n, rule.from_left[i] - Ball(1));
  }
  return ratio(sum, rule.remainder(largest_chebyshev(2 * n, rho), rho));
}

/// Next to the power -1 the mass changes fastest with the power.
double jacobi_powers() {
  const Rational power = -0.999_r, radius = 1e-9_r;
  const JacobiRule rule(3, midpoint_and_radius(power, radius, bits), Ball(0.3_r, bits), bits);
  const Ball a(Rational(power - radius + 1), bits), b(1.3_r, bits);
  Ball sum(0, bits);
  for (const Ball& weight : rule.weights) sum += weight.midpoint();
  return ratio(enclosure::power(Ball(2, bits), a + b - 1) * beta(a, b) - sum, rule.remainder(Ball(1)));
}

/// The terms of C/(1 - t d) reach C t^k. Returns the ratio for one of its value, its slope, its second derivative.
double taylor(int derivative) {
  constexpr int m = 5;
  const Ball size(3, bits), t(7, bits), reach(two_to(-13), bits), q = t * reach;
  const TaylorRest rest = taylor_rest(size, t, q, m);
  Ball tail(0, bits);
  for (int k = derivative == 2 ? 2 : m + 1; k < 60; ++k) {
    int factor = 1;
    for (int i = 0; i < derivative; ++i) factor *= k - i;
    tail += Ball(factor) * size * power(t, k) * power(reach, k - derivative);
  }
  return ratio(tail, derivative == 0 ? rest.value : derivative == 1 ? rest.slope : rest.curvature);
}

/// T_2n, whose integral over [0, L] is L/(1 - 4n^2).
double power_panel() {
  constexpr int n = 7;
  JacobiRules rules(bits);
  const PowerPanel panel(300, Ball(0), Ball(0), {}, n, rules);
  const Ball sum =
      sum_over(panel.nodes(), [](const auto& node) { return chebyshev_polynomial(2 * n, node.from_left / 150 - 1); });
  return ratio(Ball(300, bits) / (1 - 4 * n * n) - sum, panel.remainder(largest_chebyshev(2 * n, panel.rho())));
}

double power_panel_powers() {
  const Rational power = -0.999_r, radius = 1e-9_r;
  JacobiRules rules(bits);
  const PowerPanel panel(3, midpoint_and_radius(power, radius, bits), Ball(0.3_r, bits), {}, 3, rules);
  const Ball a(Rational(power - radius + 1), bits), b(1.3_r, bits);
  const Ball value = enclosure::power(Ball(3, bits), a + b - 1) * beta(a, b);
  return ratio(value - sum_over(panel.nodes(), one<PowerPanel::Node>).midpoint(), panel.remainder_of_polynomial(1));
}

/// G = x T_2n(x) with the pole at 0: the difference quotient is T_2n, whose integral is 2/(1 - 4n^2).
double principal_value() {
  constexpr int n = 8;
  JacobiRules rules(bits);
  const PowerPanel panel(2, Ball(0), Ball(0), {}, n, rules);
  const Ball sum =
      sum_over(panel.nodes(), [](const auto& node) { return chebyshev_polynomial(2 * n, node.from_left - 1); });
  const Ball rho = panel.rho();
  const Ball bound_of_G = (rho + 1 / rho) / 2 * largest_chebyshev(2 * n, rho);
  return ratio(Ball(2, bits) / (1 - 4 * n * n) - sum, panel.remainder_of_principal_value(bound_of_G));
}

/// The step and the strip of a rule on [0, L] with the powers l, r at its ends, from its nodes and its lens.
struct Strip {
  Trapezoidal rule;
  Ball step;
  Ball half_width;

  Strip(const Rational& l, const Rational& r, const std::optional<Trapezoidal::Pole>& pole, Bits accuracy)
      : rule(Ball(1, bits), Ball(l, bits), Ball(r, bits), {}, pole, 0, accuracy),
        step(tau(1) - tau(0)),
        half_width(2 * atan(2 * rule.lens_radius().at(bits))) {}

  Ball tau(std::size_t k) const { return log(rule.nodes()[k].from_left / rule.nodes()[k].from_right); }
  /// Returns the largest value of cos(2 pi tau/h) in the strip.
  Ball growth() const {
    const Ball e = exp(2 * Ball::pi(bits) * half_width / step);
    return (e + 1 / e) / 2;
  }
};

/// cos(2 pi tau/h) is -1 at every node. Its integral with the weight is Re B(l+1+iw, r+1-iw), w = 2 pi/h: nearly 0.
double trapezoidal_strip() {
  const Rational power = -0.75_r;
  const Strip strip(power, power, {}, 40);
  const Ball w = 2 * Ball::pi(bits) / strip.step;
  acb_t z, value;
  acb_init(z);
  acb_init(value);
  arb_set(acb_realref(z), Ball(Rational(power + 1), bits).get());
  arb_set(acb_imagref(z), w.get());
  acb_gamma(value, z, bits);  // |Gamma(a + iw)|^2/Gamma(2a)
  Ball exact = made_by(acb_abs, bits, value, bits);
  acb_clear(z);
  acb_clear(value);
  exact = exact * exact / gamma(Ball(Rational(2 * power + 2), bits));
  return ratio(exact + sum_over(strip.rule.nodes(), one<Trapezoidal::Node>), strip.rule.remainder(strip.growth()));
}

/// sin(2 pi (tau - tau_p)/h) is 0 at every node. Its principal value with the pole p is pi w(p), up to e^(-2 pi^2/h):
/// i pi times the residue at p.
double trapezoidal_pole() {
  const Rational power = -0.75_r;
  const Ball p(0.5_r, bits);
  const Strip strip(power, power, Trapezoidal::Pole{p, p}, 12);
  const Ball exact = Ball::pi(bits) * enclosure::power(p, Ball(Rational(2 * power), bits));
  return ratio(exact, strip.rule.remainder(strip.growth()));
}

/// A rule for a degree that its integrand does not have: the strip's part of the bound is nearly 0, and what is left is
/// the nodes beyond the ends.
double trapezoidal_tail(const Rational& left, const Rational& right) {
  const Ball l(left, bits), r(right, bits);
  const Trapezoidal rule(2, l, r, {}, std::nullopt, 60, 30);
  const Ball value = power(Ball(2, bits), l + r + 1) * beta(l + 1, r + 1);
  return ratio(value - sum_over(rule.nodes(), one<Trapezoidal::Node>), rule.remainder(1));
}

/// The same with a pole beside the end: the nodes beyond that end have most of the error. PV int_0^2 dy/(y - p).
double trapezoidal_tail_beside_pole(const Rational& p) {
  const Ball from_left(p, bits), from_right(Rational(2 - p), bits);
  const Trapezoidal rule(2, Ball(0), Ball(0), {}, Trapezoidal::Pole{from_left, from_right}, 60, 30);
  return ratio(log(from_right / from_left) - sum_over(rule.nodes(), one<Trapezoidal::Node>), rule.remainder(1));
}

/// A polynomial that grows in the lens; degree and bits by a scan.
double trapezoidal_lens() {
  constexpr int degree = 2;
  const Trapezoidal rule(2, Ball(0), Ball(0), {}, std::nullopt, degree, 4);
  const Ball sum = sum_over(rule.nodes(), [](const auto& node) { return power(node.from_left - 1, degree); });
  return ratio(Ball(2, bits) / (degree + 1) - sum, rule.remainder(power(rule.lens_radius(), degree)));
}

/// A power at the end of the ellipse where it is largest.
double outside_product(const Rational& p) {
  const Ball length(2, bits), reach(0.4_r, bits), nearly = reach * Ball(0.9999_r, bits);
  const OutsideProduct product({{Side::left, Ball(0.5_r, bits), Ball(p, bits)}});
  const Ball value = p < 0 ? product.at(-nearly, length + nearly) : product.at(length + nearly, -nearly);
  return ratio(value, product.bound(length, reach));
}

/// The power at the end of its ball, at a place whose logarithm is large.
double outside_power_radius() {
  const Rational radius = 1e-9_r;
  const Ball distance(two_to(-400), bits);
  const OutsideProduct product({{Side::left, distance, midpoint_and_radius(0.5_r, radius, bits)}});
  const Ball value = product.at(Ball(0), Ball(1, bits));
  return ratio(power(distance, Ball(Rational(0.5_r - radius), bits)) - value.midpoint(), value.radius());
}

template <class F>
ChebyshevSeries series_of(const ChebyshevNodes& nodes, F f, const Ball& bound, const Ball& rho) {
  std::vector<Ball> values;
  for (int i = 0; i < nodes.count(); ++i) values.push_back(f(nodes[i]));
  return {nodes, values, bound, rho};
}

/// T_n is 0 at its own nodes.
double chebyshev_truncation() {
  constexpr int n = 7;
  const ChebyshevNodes nodes(n, bits);
  const Ball rho(5, bits);
  const auto series = series_of(
      nodes, [](const Ball& /*t*/) { return Ball(0, bits); }, largest_chebyshev(n, rho), rho);
  return ratio(Ball(1), series.at(Ball(1, bits)).radius());
}

/// Values +-1 with alternating signs, at t = 1: sum |l_i(1)| = (1/n) sum cot((2i+1) pi/(4n)).
double chebyshev_lebesgue() {
  constexpr int n = 16;
  const ChebyshevNodes nodes(n, bits);
  const auto series = series_of(
      nodes, [](const Ball& /*t*/) { return Ball::around(Ball(0, bits), Ball(1, bits)); }, Ball(0), Ball(5, bits));
  Ball largest(0, bits);
  for (int i = 0; i < n; ++i) {
    const Ball angle = Ball::pi(bits) * Ball(2 * i + 1) / Ball(4 * n);
    largest += cos(angle) / sin(angle) / Ball(n);
  }
  return ratio(largest, series.range().radius());
}

/// Two nodes with few bits: the rounding of the coefficients. The bits and t = 1 were found by a scan.
double chebyshev_rounding() {
  const ChebyshevNodes nodes(2, 7), exact(2, bits);
  std::vector<Ball> values;
  for (int i = 0; i < 2; ++i) values.push_back((nodes[i] * nodes[i] / 3).midpoint());
  const ChebyshevSeries series(nodes, values, Ball(0), Ball(5, bits)), fine(exact, values, Ball(0), Ball(5, bits));
  const Ball t(1, bits);
  return ratio(fine.at(t) - series.at(t).midpoint(), series.at(t).radius());
}

double chebyshev_range() {
  const ChebyshevNodes nodes(9, bits);
  const auto f = [](const Ball& t) { return chebyshev_polynomial(3, t) - chebyshev_polynomial(5, t); };
  const auto series = series_of(nodes, f, Ball(0), Ball(5, bits));
  Ball most(0);
  for (int k = 0; k <= 400; ++k) most = max(most, abs(f(Ball(Rational(k, 400), bits))).midpoint());
  return ratio(most, series.range().upper());
}

double polynomial_within_radius() {
  const BallPolynomial p{Ball(1, bits), Ball(-3, bits), Ball(2, bits)};
  return ratio(value_at(p, Ball(-0.7_r, bits)), bound_within(p, Ball(0.7_r, bits)));
}

TEST_CASE("bounds of quadratures and series: a true error that nearly reaches each") {
  check_sharp_bounds("test_enclosure",
                     {{"jacobi-remainder", jacobi_remainder},
                      {"jacobi-powers", jacobi_powers},
                      {"taylor-value", [] { return taylor(0); }},
                      {"taylor-slope", [] { return taylor(1); }},
                      {"taylor-curvature", [] { return taylor(2); }},
                      {"power-panel", power_panel},
                      {"power-panel-powers", power_panel_powers},
                      {"principal-value", principal_value},
                      {"trapezoidal-strip", trapezoidal_strip},
                      {"trapezoidal-pole", trapezoidal_pole},
                      {"trapezoidal-tail-left", [] { return trapezoidal_tail(-0.5_r, 0.3_r); }},
                      {"trapezoidal-tail-right", [] { return trapezoidal_tail(1, -0.7_r); }},
                      {"trapezoidal-tail-left-of-pole", [] { return trapezoidal_tail_beside_pole(0.1_r); }},
                      {"trapezoidal-tail-right-of-pole", [] { return trapezoidal_tail_beside_pole(1.9_r); }},
                      {"trapezoidal-lens", trapezoidal_lens},
                      {"outside-nearest", [] { return outside_product(-0.7_r); }},
                      {"outside-farthest", [] { return outside_product(0.7_r); }},
                      {"outside-power-radius", outside_power_radius},
                      {"chebyshev-truncation", chebyshev_truncation},
                      {"chebyshev-lebesgue", chebyshev_lebesgue},
                      {"chebyshev-rounding", chebyshev_rounding},
                      {"chebyshev-range", chebyshev_range},
                      {"polynomial-within-radius", polynomial_within_radius}});
}

}  // namespace steadyslide::sharp_quadratures
