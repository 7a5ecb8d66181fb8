// Series of polynomials and of an analytic function; a part of a series compared with the whole. Their bounds are in
// quadrature/sharp_bounds_test.cpp.

#include "enclosure/number/chebyshev_series.hpp"

#include "support/enclosure_test.hpp"

namespace {

constexpr Bits bits = 128;

template <class Function>
ChebyshevSeries series_of(const ChebyshevNodes& nodes, const Function& f, const Ball& bound, const Ball& rho) {
  std::vector<Ball> values;
  for (int i = 0; i < nodes.count(); ++i) values.push_back(f(nodes[i]));
  return {nodes, values, bound, rho};
}

}  // namespace

TEST_CASE("T_k of a lower degree: its range, and its values on a part to the last digits") {
  const ChebyshevNodes nodes(12, bits);
  for (const int k : {1, 2, 5, 11}) {
    const auto f = [k](const Ball& t) { return chebyshev_polynomial(k, t); };
    const ChebyshevSeries whole = series_of(nodes, f, Ball(0, bits), Ball(5, bits));
    CHECK(whole.range().overlaps(Ball(1, bits)));
    CHECK(whole.range().upper() < Ball(1.0000001_r, bits));
    const Ball from(-0.75_r, bits), to(-0.5_r, bits);
    const ChebyshevSeries part = whole.restricted(from, to);
    for (const Rational& t : {-1_r, -0.3_r, 0_r, 0.9_r, 1_r}) {
      const Ball here(t, bits);
      const Ball value = f((from + to) / 2 + (to - from) / 2 * here);
      CHECK(part.at(here).overlaps(value));
      CHECK(part.at(here).radius() < power(Ball(2, bits), -96));
      CHECK(part.range().overlaps(value));
    }
    // The range is as narrow as the part: |T_k'| <= k^2.
    CHECK(part.range().radius() < Ball(k * k, bits) / 8 * 2);
  }
}

TEST_CASE("an analytic function lies within its error, which is no more than its last terms") {
  const Ball pole(1.5_r, bits), rho(2, bits);  // the ellipse reaches 1.25
  const auto f = [&](const Ball& t) { return Ball(1) / (pole - t); };
  Ball width_before = Ball::unknown(bits);
  for (const int n : {8, 16, 32}) {
    const ChebyshevNodes nodes(n, bits);
    const ChebyshevSeries series = series_of(nodes, f, Ball(4, bits), rho);
    for (int k = -10; k <= 10; ++k) {
      const Ball t(Rational(k, 10), bits);
      CHECK(series.at(t).contains(f(t)));
      CHECK(series.restricted(t, Ball(1, bits)).at(Ball(-1, bits)).contains(f(t)));
    }
    const Ball width = series.at(Ball(0, bits)).radius();
    if (n > 8) CHECK(width < width_before / 200);
    width_before = width;
  }
}
