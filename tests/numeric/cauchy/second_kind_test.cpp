// Cauchy integrals of powers, compared with closed forms and with three independent quadratures; relations between
// them.

#include <type_traits>

#include "numeric/cauchy/second_kind.hpp"
#include "numeric/quadrature/jacobi_rule.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "support/numeric_test.hpp"

using second_kind::left_of;

namespace {

template <Real R>
R ten_to(int exponent) {
  using std::pow;
  return pow(R(10), exponent);
}

/// Evenly distributed; every second one close to -1, 0 or 1.
template <Real R>
Power<R> random_end_power() {
  using std::pow;
  const R tiny = pow(R(10), R(-uniform(5, 240)) / 20), even = R(uniform(1, 199)) / 100;
  switch (uniform(0, 7)) {
    case 0: return {tiny - 1, tiny};
    case 1: return {tiny, 1 + tiny};
    case 2: return {-tiny, 1 - tiny};
    case 3: return {1 - tiny, 2 - tiny};
    default: return {even - 1, even};
  }
}

/// Between 1e-12 and 1e4; one in four down to 1e-100.
template <Real R>
R random_distance() {
  using std::pow;
  return pow(R(10), R(uniform(0, 3) == 0 ? uniform(-1000, 0) : uniform(-120, 40)) / 10);
}

}  // namespace

TEST_CASE_TEMPLATE("closed forms at a = -1/2, 0, 1/2, for d from 1e-300 to 1e10", R, double, Real50, Real100) {
  using std::atan, std::log1p, std::sqrt;
  const Power<R> low{R(-0.5), R(0.5)};
  const Power<R> zero{R(0), R(1)};
  const Power<R> high{R(0.5), R(1.5)};
  for (const int exponent : {-300, -30, -8, -3, -1, 0, 1, 4, 10}) {
    for (const R& d : {ten_to<R>(exponent), R(6 * ten_to<R>(exponent)), R(ten_to<R>(exponent) / 3)}) {
      CAPTURE(static_cast<double>(d));
      const R root = sqrt(d), angle = atan(1 / root);
      CHECK(close(left_of(low, d), R(2 * angle / root), 20));
      CHECK(close(left_of(zero, d), R(log1p(1 / d)), 20));
      CHECK(close(left_of(high, d), R(2 - 2 * root * angle), 20, R(2)));
    }
  }
}

TEST_CASE_TEMPLATE("halves: y = z/2 on the first one, a Gauss rule on the second", R, double, Real50, Real100) {
  using std::pow;
  // On [1/2, 1] the nearest singular point is three half-lengths away from the middle.
  const UnitRule<R> rule = jacobi_rule<R>({R(0), R(1)}, {R(0), R(1)}, digits_served<R> * 8 / 10 + 10);
  CHECK(rc::check("halves", [&] {
    const Power<R> a = random_end_power<R>();
    const R d = random_distance<R>(), whole = left_of(a, d), first = left_of(a, R(2 * d));
    R second = 0;
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const R y = (1 + rule.from_left[i]) / 2;
      second += rule.weights[i] / 2 * pow(y, a.value) / (y + d);
    }
    RC_ASSERT(close(R(pow(R(2), R(-a.value)) * first + second), whole, 100));
    // Control: the power with the opposite sign.
    if (a.value > 0.01 || a.value < -0.01) RC_ASSERT(!close(R(pow(R(2), a.value) * first + second), whole, 1e6));
  }));
}

TEST_CASE_TEMPLATE("recurrence: y^(a+1)/(y + d) = y^a - d y^a/(y + d)", R, double, Real50, Real100) {
  CHECK(rc::check("recurrence", [] {
    Power<R> a = random_end_power<R>();
    if (a.value >= 0) a = {a.value - 1, a.value};
    if (!(a.plus_one > 0)) return;
    const Power<R> next{a.plus_one, a.plus_one + 1};
    const R inverse = 1 / a.plus_one, d = random_distance<R>();
    RC_ASSERT(close(left_of(next, d), R(inverse - d * left_of(a, d)), 100, inverse));
  }));
}

TEST_CASE_TEMPLATE("a precision and the next serve the same number", R, double, Real50) {
  using Finer = std::conditional_t<std::same_as<R, double>, Real50, Real100>;
  CHECK(rc::check("precisions", [] {
    const Power<R> a = random_end_power<R>();
    // The same power as the coarse one got: the smaller one of a and 1 + a is the accurate one.
    const Power<Finer> fine = a.plus_one < 0.5 ? Power<Finer>{Finer(a.plus_one) - 1, Finer(a.plus_one)}
                                               : Power<Finer>{Finer(a.value), Finer(a.value) + 1};
    const auto error = [](const R& value, const Finer& exact, const Finer& part) {
      return static_cast<double>(Finer(abs(Finer(value) - exact) / (abs(exact) + part) / Finer(epsilon<R>())));
    };
    const R d = random_distance<R>();
    RC_ASSERT(error(left_of(a, d), left_of(fine, Finer(d)), Finer(0)) < 30);
  }));
}

TEST_CASE_TEMPLATE("through a = 0 with the slope int log(y)/(y + d) dy, without a jump", R, double, Real50) {
  using std::log;
  const R h = R(1e-12);
  for (const int exponent : {-300, -20, -3, -1, 0, 3}) {
    const R d = ten_to<R>(exponent) / 3;
    const R middle = left_of(Power<R>{R(0), R(1)}, d);
    const R up = left_of(Power<R>{h, 1 + h}, d) - middle;
    const R down = left_of(Power<R>{-h, 1 - h}, d) - middle;
    const R logarithm = size_of(R(log(d)));
    // |log y|, and its square, integrated against 1/(y + d).
    const R slope = (1 + logarithm) * (2 + logarithm);
    const R rounding = 20 * epsilon<R>() * (1 + size_of(middle) + logarithm);
    CHECK(size_of(up) <= h * slope + rounding);
    CHECK(size_of(R(up + down)) <= h * h * slope * (2 + logarithm) + rounding);
    if (std::same_as<R, Real50>) CHECK(size_of(up) > 1e-3 * h * size_of(middle));
  }
}

TEST_CASE_TEMPLATE("Gauss-Jacobi rules, far from the pole", R, double, Real50, Real100) {
  // The error falls like (sqrt(d) + sqrt(1 + d))^(-4n).
  const int n = 12 * digits_served<R> / 10 + 10;
  for (const char* plus_one : {"1e-12", "0.001", "0.3", "0.999999", "1", "1.2", "1.8"}) {
    CAPTURE(plus_one);
    const R given = to_real<R>(parse_rational(plus_one));
    const Power<R> a{to_real<R>(Rational(parse_rational(plus_one) - 1)), given};
    const UnitRule<R> rule = jacobi_rule(a, {R(0), R(1)}, n);
    for (const R& d : {R(0.4), R(0.59), R(0.61), R(0.99), R(1.01), R(30)}) {
      CAPTURE(static_cast<double>(d));
      R left = 0;
      for (std::size_t i = 0; i < rule.size(); ++i) left += rule.weights[i] / (rule.from_left[i] + d);
      CHECK(close(left_of(a, d), left, 200));
    }
  }
}

TEST_CASE_TEMPLATE("tanh-sinh and trapezoidal routes", R, double, Real50) {
  using std::log, std::pow;
  const auto one = [](const Node<R>&) { return R(1); };
  const Panel<R> unit{0, 1, 1};
  const Power<R> none{R(0), R(1)};
  for (const Rational& s : {0_r, 40_r, Rational(-40), Rational(1, 3), Rational(-3)}) {
    for (const Exponent& exponent : {Exponent::angle(s) - half, Exponent::angle(s)}) {
      CAPTURE(to_string(exponent));
      const Power<R> a = Power<R>::of(exponent);
      const PiecewiseDensity<R> density{{unit, a, none, one}}, mirrored{{unit, none, a, one}};
      const trapezoidal::Grid<R> grid(density), mirrored_grid(mirrored);
      for (const R& d : {R(1e-3), R(0.3), R(2)}) {
        const R value = left_of(a, d) / pi<R>();
        CHECK(close(tanh_sinh::cauchy(density, Side::left, d).value, value, 2000));
        CHECK(close(tanh_sinh::cauchy(mirrored, Side::right, d).value, R(-value), 2000));
        CHECK(close(grid.cauchy(Side::left, d), value, 2000));
        CHECK(close(mirrored_grid.cauchy(Side::right, d), R(-value), 2000));
        CHECK(close(grid.cauchy(Side::right, d), tanh_sinh::cauchy(density, Side::right, d).value, 2000));
      }
      for (const R& x : {R(1e-3), R(0.3), R(0.7)}) {
        const Node<R> node = unit.node_from_left(x);
        // The size of the terms that may cancel.
        const R part = pow(x, a.value) * (1 + size_of(R(log(node.from_right))) + 1 / a.plus_one);
        CHECK(close(tanh_sinh::hilbert(density, {0, node}).value, grid.hilbert({0, node}), 2000, part));
      }
    }
  }
}

TEST_CASE("next to a = -1 the exponent's last digits count") {
  // int_0^1 y^a/(y + d) dy ~ 1/((1+a) d): the integral comes from the end.
  CHECK(close(left_of(Power<double>{-1, 1e-20}, 0.01), 1e22, 10));
}
