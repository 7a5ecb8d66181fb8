// Every quadrature, compared with integrals of known value. Each line is a case.

#include "numeric/cauchy/sliding_operator.hpp"
#include "numeric/quadrature/gsl_quadrature.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "support/numeric_test.hpp"

namespace {

/// (1+x)^left (1-x)^right g on ]-1, 1[ as one panel.
template <Real R>
PiecewiseDensity<R> jacobi(const Exponent& left, const Exponent& right, std::function<R(const Node<R>&)> g) {
  return {{Panel<R>{-1, 1, 2}, Power<R>::of(left), Power<R>::of(right), std::move(g)}};
}

template <Real R>
R one(const Node<R>&) {
  return 1;
}

}  // namespace

TEST_CASE_TEMPLATE("normalisation of Galin's punch: int (1+x)^(-1/2-a) (1-x)^(-1/2+a) dx = pi/cos(pi a)", R, double,
                   Real50, Real100) {
  using std::abs, std::sqrt;
  // s = tan(pi a); cos(pi a) = 1/sqrt(1+s^2). For s = 1000, 14 of 15 parts of the load are in the last 1e-16 of the
  // rear end.
  for (const Rational& s : {0_r, Rational(1, 7), Rational(-5), 37_r, 1000_r}) {
    CAPTURE(to_string(s));
    const Exponent a = Exponent::angle(s);
    const auto density = jacobi<R>(-half - a, -half + a, one<R>);
    const R expected = pi<R>() / cos_pi_alpha<R>(s);
    const Estimate<R> first = tanh_sinh::integral(density);
    CHECK(close(first.value, expected, 60));
    CHECK(first.convergence == Convergence::reached);
    CHECK(abs(first.value - expected) <= first.error);
    CHECK(close(trapezoidal::Grid<R>(density).integral(), expected, 60));
    if constexpr (std::same_as<R, double>) {
      const Estimate<double> third = gsl::integral(density);
      CHECK(third.convergence == Convergence::reached);
      CHECK(close(third.value, expected, 2000));
    }
  }
}

TEST_CASE("a power that is almost -1: what the rest of the density does is a part of the integral, and of the error") {
  for (int k = 4; k <= 300; ++k) {
    const double small = std::pow(10, -k / 12.);
    CAPTURE(small);
    const Real50 beta = small;
    // int d^(beta-1) (1-d)^5 dd over [0, 1]
    const auto fifth_power = [](const Node<double>& node) { return std::pow(node.from_right, 5); };
    const Estimate<double> found =
        tanh_sinh::panel_integral<double>({Panel<double>{0, 1, 1}, {small - 1, small}, {0, 1}, fifth_power});
    Real50 expected = 120;
    for (int factor = 0; factor <= 5; ++factor) expected /= factor + beta;
    CHECK(abs(Real50(found.value) / expected - 1) <= Real50(found.error) / expected);
    CHECK(found.error <= 1e-14 * found.value);
    CHECK(found.convergence == Convergence::reached);
  }
}

TEST_CASE("control: with x alone instead of the distance the same integral is wrong in the first digits") {
  const Rational s = 37;
  const Exponent a = Exponent::angle(s);
  const double left = to_real<double>(-half - a), right = to_real<double>(-half + a);
  const PiecewiseDensity<double> naive{{Panel<double>{-1, 1, 2}, {0, 1}, {0, 1}, [&](const Node<double>& node) {
                                          const double d = 1 + node.x;
                                          return d > 0 && node.x < 1 ? std::pow(d, left) * std::pow(1 - node.x, right)
                                                                     : 0.0;
                                        }}};
  const double expected = pi<double>() / cos_pi_alpha<double>(s);
  CHECK(std::abs(tanh_sinh::integral(naive).value / expected - 1) > 0.1);
}

TEST_CASE_TEMPLATE("the published integral: Galin's punch with s = 1 seen from x = 2 is -pi sqrt(2)/3^(3/4)", R, double,
                   Real50, Real100) {
  using std::pow, std::sqrt;
  const Exponent quarter(-0.25_r);
  const auto density = jacobi<R>(Exponent(-0.75_r), quarter, one<R>);
  const R expected = -sqrt(R(2)) / pow(R(3), R(3) / 4);
  CHECK(close(tanh_sinh::cauchy(density, Side::right, R(1)).value, expected, 100));
  CHECK(close(trapezoidal::Grid<R>(density).cauchy(Side::right, R(1)), expected, 100));
}

TEST_CASE("published principal values (tests of SingularIntegralEquations.jl), x = 0.1, with e^x in the density") {
  struct Case {
    Panel<double> panel;
    Exponent power;
    double expected;
  };
  const Case cases[] = {
      {{-1, 1, 2}, -half, 1.1404096104609646},
      {{-1, 1, 2}, half, 0.43723982258866913},
      {{-1, 2, 3}, -half, 1.6649936695644078},
  };
  for (const Case& c : cases) {
    const auto e_to_x = [](const Node<double>& node) { return std::exp(node.x); };
    const PiecewiseDensity<double> density{{c.panel, Power<double>::of(c.power), Power<double>::of(c.power), e_to_x}};
    const PanelPoint<double> at{0, {0.1, 0.1 - c.panel.left, c.panel.right - 0.1}};
    CHECK(close(tanh_sinh::hilbert(density, at).value, c.expected, 100));
    CHECK(close(gsl::hilbert(density, at).value, c.expected, 1000));
    // e^x is not analytic at the border of the strip that the trapezoidal step assumes. The header says that there are
    // then fewer digits.
    CHECK(trapezoidal::Grid<double>(density).hilbert(at) == doctest::Approx(c.expected).epsilon(1e-9));
  }
}

TEST_CASE_TEMPLATE("H of Galin's weight is -tan(pi a) times it, from 1e-9 of an end to 1e-9 of the other", R, double,
                   Real50, Real100) {
  for (const Rational& s : {Rational(1, 3), Rational(-2), 40_r}) {
    CAPTURE(to_string(s));
    const Exponent a = Exponent::angle(s);
    const auto density = jacobi<R>(-half - a, -half + a, one<R>);
    const trapezoidal::Grid<R> grid(density);
    // A place takes a second at 100 digits, so only the nearest and one inside are tested.
    for (const char* distance :
         std::same_as<R, Real100> ? std::vector{"1e-9", "0.7"} : std::vector{"1e-9", "1e-3", "0.7", "1"}) {
      const R d = to_real<R>(parse_rational(distance));
      for (const Node<R>& node : {density[0].panel.node_from_left(d), density[0].panel.node_from_right(d)}) {
        const PanelPoint<R> at{0, node};
        const R expected = -to_real<R>(s) * density[0](node);
        CHECK(close(tanh_sinh::hilbert(density, at).value, expected, 2000));
        CHECK(close(grid.hilbert(at), expected, 2000));
        if constexpr (std::same_as<R, double>) {
          const Estimate<double> third = gsl::hilbert(density, at);
          if (third.convergence == Convergence::reached) CHECK(close(third.value, expected, 50000));
        }
      }
    }
  }
}

TEST_CASE("the Mellin symbol: H of a power on the right of 0, seen from the left, over a wide panel") {
  // (1/pi) int_0^1 y^l/(y+d) dy = -d^l/sin(pi l) - (1/pi) sum_n (-d)^n/(n - l), l = -1/4, d = 1/1000.
  const Exponent power_of_density(-0.25_r);
  const double l = -0.25;
  const PiecewiseDensity<double> density{
      {Panel<double>{0, 1, 1}, Power<double>::of(power_of_density), Power<double>::of(Exponent(0)), one<double>}};
  const double d = 1e-3;
  double series = 0, power = 1;
  for (int n = 0; n < 8; ++n, power *= -d) series += power / (n - l);
  const double expected = -std::pow(d, l) / std::sin(pi<double>() * l) - series / pi<double>();
  CHECK(close(tanh_sinh::cauchy(density, Side::left, d).value, expected, 100));
  CHECK(close(trapezoidal::Grid<double>(density).cauchy(Side::left, d), expected, 100));
}

TEST_CASE("a point off the grid's midpoints and one on them agree") {
  const Exponent a = Exponent::angle(0.5_r);
  const auto density = jacobi<Real50>(-half - a, -half + a, one<Real50>);
  const trapezoidal::Grid<Real50> grid(density);
  const PanelPoint<Real50> on = grid.midpoint_near(0, Real50(0.3));
  const Real50 expected = -density[0](on.node) / 2;
  CHECK(close(grid.hilbert(on), expected, 200));
  PanelPoint<Real50> off{0, density[0].panel.node_from_left(Real50(on.node.from_left + Real50(1) / 1000))};
  CHECK(close(grid.hilbert(off), Real50(-density[0](off.node) / 2), 200));
}

TEST_CASE("the operator annihilates Galin's punch by every route, and not one with the sign of s reversed") {
  const Rational s(3, 4);
  const Exponent a = Exponent::angle(s);
  const auto density = jacobi<double>(-half - a, -half + a, one<double>);
  const PanelPoint<double> at{0, density[0].panel.node_from_left(0.3)};
  for (const Route route : {Route::tanh_sinh, Route::trapezoidal, Route::gsl}) {
    const Estimate<double> zero = SlidingOperator<double>(density, {0.75}, route).at(at).sum();
    CHECK(std::abs(zero.value) < 1e-14);
    CHECK(std::abs(zero.value) <= zero.error);
    CHECK(std::abs(SlidingOperator<double>(density, {-0.75}, route).at(at).sum().value) > 0.1);
  }
  const auto fine = jacobi<Real50>(-half - a, -half + a, one<Real50>);
  const PanelPoint<Real50> there{0, fine[0].panel.node_from_left(Real50(0.3))};
  CHECK(abs(SlidingOperator<Real50>(fine, {Real50(0.75)}, Route::tanh_sinh).at(there).sum().value) < 1e-54);
  CHECK_THROWS_AS(SlidingOperator<Real50>(fine, {Real50(0.75)}, Route::gsl), std::invalid_argument);
}
