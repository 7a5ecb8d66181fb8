// Bounds of quadratures and series, each for a function whose error nearly reaches it.

#include "support/sharp_bounds.hpp"
#include "enclosure/number/ball_polynomial.hpp"
#include "enclosure/number/chebyshev_series.hpp"
#include "enclosure/quadrature/jacobi_polynomial.hpp"
#include "support/enclosure_test.hpp"

namespace steadyslide::sharp_quadratures {

constexpr Bits bits = 300;

double ratio(const Ball& error, const Ball& bound) { return (abs(error) / bound).to_double(); }

Ball beta(const Ball& a, const Ball& b) { return gamma(a) * gamma(b) / gamma(a + b); }

/// Returns max |T_k| on the ellipse rho.
Ball largest_chebyshev(int k, const Ball& rho) { return (power(rho, k) + power(rho, -k)) / 2; }

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
  check_sharp_bounds("test_enclosure", {{"jacobi-remainder", jacobi_remainder},
                                        {"jacobi-powers", jacobi_powers},
                                        {"taylor-value", [] { return taylor(0); }},
                                        {"taylor-slope", [] { return taylor(1); }},
                                        {"taylor-curvature", [] { return taylor(2); }},
                                        {"chebyshev-truncation", chebyshev_truncation},
                                        {"chebyshev-lebesgue", chebyshev_lebesgue},
                                        {"chebyshev-rounding", chebyshev_rounding},
                                        {"chebyshev-range", chebyshev_range},
                                        {"polynomial-within-radius", polynomial_within_radius}});
}

}  // namespace steadyslide::sharp_quadratures
