// Cauchy integrals of powers against closed forms, three unrelated quadratures and the relations between them.

#include <type_traits>

#include "numeric/cauchy/second_kind.hpp"
#include "numeric/quadrature/jacobi_rule.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "support/numeric_test.hpp"

using second_kind::left_of;
using second_kind::on_interval;
using second_kind::right_of;

namespace {

template <Real R>
R ten_to(int exponent) {
  using std::pow;
  return pow(R(10), exponent);
}

/// Evenly, or one in two near to -1, 0 or 1.
template <Real R>
Power<R> random_power() {
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

/// Between 1e-12 and 1e4, or one in four down to 1e-100.
template <Real R>
R random_distance() {
  using std::pow;
  return pow(R(10), R(uniform(0, 3) == 0 ? uniform(-1000, 0) : uniform(-120, 40)) / 10);
}

template <Real R>
struct Inside {
  R x;
  R rest;
};

template <Real R>
Inside<R> random_inside() {
  const R d = random_distance<R>();
  // d : 1 divides the interval.
  const R small = d / (1 + d), large = 1 / (1 + d);
  return uniform(0, 1) == 0 ? Inside<R>{small, large} : Inside<R>{large, small};
}

/// The size of what may cancel in `on`.
template <Real R>
R parts(const Power<R>& a, const Inside<R>& at) {
  using std::log, std::pow;
  return pow(at.x, a.value) * (1 + size_of(R(log(at.rest))) + 1 / a.plus_one);
}

}  // namespace

TEST_CASE_TEMPLATE("closed forms at a = -1/2, 0, 1/2, for d from 1e-300 to 1e10", R, double, Real50, Real100) {
  using std::atan, std::atanh, std::log, std::log1p, std::sqrt;
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
      const R far = sqrt(1 + d), logarithm = 2 * log1p(far) - log(d);
      CHECK(close(right_of(zero, d), R(log1p(1 / d)), 20));
      CHECK(close(right_of(low, d), R(logarithm / far), 20, R(log(1 + d))));
      CHECK(close(right_of(high, d), R(far * logarithm - 2), 20, R(2 + far * log(1 + d))));
      if (d >= 1) continue;
      for (const Inside<R>& at : {Inside<R>{d, 1 - d}, Inside<R>{1 - d, d}}) {
        const R s = sqrt(at.x);
        const R difference = at.x < 0.5 ? R(-2 * atanh(s)) : R(log(at.rest) - 2 * log1p(s));
        // The cotangent vanishes, and leaves nothing of the size of 1/s.
        CHECK(close(on_interval(low, at.x, at.rest), R(difference / s), 20, R(1)));
        CHECK(close(on_interval(zero, at.x, at.rest), R(log(at.rest) - log(at.x)), 20, R(1)));
        CHECK(close(on_interval(high, at.x, at.rest), R(2 + s * difference), 20, R(2)));
      }
    }
  }
}

TEST_CASE_TEMPLATE("squares: y^2 as the variable relates all three functions at two exponents and two distances", R,
                   double, Real50, Real100) {
  // 1/(w - y) + 1/(w + y) = 2w/(w^2 - y^2), their difference 2y/(w^2 - y^2); the same with w = x on the interval.
  CHECK(rc::check("squares", [] {
    const Power<R> a = random_power<R>();
    const Power<R> even{(a.value - 1) / 2, a.plus_one / 2};
    const Power<R> odd{a.value / 2, (1 + a.plus_one) / 2};
    const R d = random_distance<R>(), w = 1 + d, outside = right_of(a, d), opposite = left_of(a, w);
    RC_ASSERT(close(R(outside + opposite), R(w * right_of(even, R(d * (2 + d)))), 100));
    RC_ASSERT(close(R(outside - opposite), right_of(odd, R(d * (2 + d))), 100, outside));
    // Control: the exponents exchanged.
    if (a.value > 0.01 || a.value < -0.01)
      RC_ASSERT(!close(R(outside + opposite), R(w * right_of(odd, R(d * (2 + d)))), 1e6));

    const Inside<R> at = random_inside<R>();
    const R square = at.x * at.x, rest = at.rest * (1 + at.x);
    const R inside = on_interval(a, at.x, at.rest), mirror = left_of(a, at.x);
    const R part = parts(a, at) + mirror;
    RC_ASSERT(close(R(inside - mirror), R(at.x * on_interval(even, square, rest)), 400, part));
    RC_ASSERT(close(R(inside + mirror), on_interval(odd, square, rest), 400, part));
  }));
}

TEST_CASE_TEMPLATE("recurrence: y^(a+1)/(y + d) = y^a - d y^a/(y + d)", R, double, Real50, Real100) {
  CHECK(rc::check("recurrence", [] {
    Power<R> a = random_power<R>();
    if (a.value >= 0) a = {a.value - 1, a.value};
    if (!(a.plus_one > 0)) return;
    const Power<R> next{a.plus_one, a.plus_one + 1};
    const R inverse = 1 / a.plus_one, d = random_distance<R>();
    RC_ASSERT(close(left_of(next, d), R(inverse - d * left_of(a, d)), 100, inverse));
    RC_ASSERT(close(right_of(next, d), R((1 + d) * right_of(a, d) - inverse), 100, R((1 + d) * right_of(a, d))));
    const Inside<R> at = random_inside<R>();
    RC_ASSERT(close(on_interval(next, at.x, at.rest), R(inverse + at.x * on_interval(a, at.x, at.rest)), 400,
                    R(inverse + at.x * parts(a, at))));
  }));
}

TEST_CASE_TEMPLATE("a precision and the next serve the same number", R, double, Real50) {
  using Finer = std::conditional_t<std::same_as<R, double>, Real50, Real100>;
  CHECK(rc::check("precisions", [] {
    const Power<R> a = random_power<R>();
    // What the coarse one was given: the smaller of both is the one that counts.
    const Power<Finer> fine = a.plus_one < 0.5 ? Power<Finer>{Finer(a.plus_one) - 1, Finer(a.plus_one)}
                                               : Power<Finer>{Finer(a.value), Finer(a.value) + 1};
    const auto error = [](const R& value, const Finer& exact, const Finer& part) {
      return static_cast<double>(Finer(abs(Finer(value) - exact) / (abs(exact) + part) / Finer(epsilon<R>())));
    };
    const R d = random_distance<R>();
    RC_ASSERT(error(left_of(a, d), left_of(fine, Finer(d)), Finer(0)) < 30);
    RC_ASSERT(error(right_of(a, d), right_of(fine, Finer(d)), Finer(0)) < 30);
    const Inside<R> at = random_inside<R>();
    const bool left = at.x < at.rest;
    const Inside<Finer> same{left ? Finer(at.x) : 1 - Finer(at.rest), left ? 1 - Finer(at.x) : Finer(at.rest)};
    RC_ASSERT(error(on_interval(a, at.x, at.rest), on_interval(fine, same.x, same.rest),
                    Finer(pow(same.x, fine.value))) < 30);
  }));
}

TEST_CASE_TEMPLATE("through a = 0 with the slope int log(y)/(y + d) dy, without a jump", R, double, Real50) {
  using std::log;
  const R h = R(1e-12);
  for (const int exponent : {-300, -20, -3, -1, 0, 3}) {
    const R d = ten_to<R>(exponent) / 3;
    const auto smooth = [&](auto&& f) {
      const R middle = f(Power<R>{R(0), R(1)});
      const R up = f(Power<R>{h, 1 + h}) - middle;
      const R down = f(Power<R>{-h, 1 - h}) - middle;
      const R logarithm = size_of(R(log(d)));
      // |log y|, and its square, integrated against 1/(y + d), or at a point against what cancels there.
      const R slope = (1 + logarithm) * (2 + logarithm);
      const R rounding = 20 * epsilon<R>() * (1 + size_of(middle) + size_of(R(log(d))));
      CHECK(size_of(up) <= h * slope + rounding);
      CHECK(size_of(R(up + down)) <= h * h * slope * (2 + logarithm) + rounding);
      if (std::same_as<R, Real50>) CHECK(size_of(up) > 1e-3 * h * size_of(middle));
    };
    smooth([&](const Power<R>& a) { return left_of(a, d); });
    smooth([&](const Power<R>& a) { return right_of(a, d); });
    if (d < 1) smooth([&](const Power<R>& a) { return on_interval(a, d, R(1 - d)); });
    if (d < 1) smooth([&](const Power<R>& a) { return on_interval(a, R(1 - d), d); });
  }
}

TEST_CASE_TEMPLATE("Gauss-Jacobi rules, far from the pole", R, double, Real50, Real100) {
  // The error falls like (sqrt(d) + sqrt(1 + d))^(-4n).
  const int n = 12 * digits_served<R> / 10 + 10;
  for (const char* plus_one : {"1e-12", "0.001", "0.3", "0.999999", "1", "1.2", "1.8"}) {
    CAPTURE(plus_one);
    const R given = to_real<R>(parse_rational(plus_one));
    const Power<R> a{to_real<R>(Rational(parse_rational(plus_one) - 1)), given};
    const JacobiRule<R> rule = jacobi_rule(a, {R(0), R(1)}, n);
    for (const R& d : {R(0.4), R(0.59), R(0.61), R(0.99), R(1.01), R(30)}) {
      CAPTURE(static_cast<double>(d));
      R left = 0, right = 0;
      for (std::size_t i = 0; i < rule.size(); ++i) {
        left += rule.weights[i] / (rule.from_left[i] + d);
        right += rule.weights[i] / (rule.from_right[i] + d);
      }
      CHECK(close(left_of(a, d), left, 200));
      CHECK(close(right_of(a, d), right, 200));
    }
  }
}

TEST_CASE_TEMPLATE("tanh-sinh and trapezoidal routes", R, double, Real50) {
  const auto one = [](const Node<R>&) { return R(1); };
  for (const Rational& s : {0_r, 40_r, Rational(-40), Rational(1, 3), Rational(-3)}) {
    for (const Exponent& exponent : {Exponent::angle(s) - half, Exponent::angle(s)}) {
      CAPTURE(to_string(exponent));
      const Power<R> a = Power<R>::of(exponent);
      const PiecewiseDensity<R> density{{Panel<R>{0, 1, 1}, a, Power<R>::of(Exponent(0)), one}};
      const trapezoidal::Grid<R> grid(density);
      for (const R& d : {R(1e-3), R(0.3), R(2)}) {
        const R left = left_of(a, d) / pi<R>(), right = -right_of(a, d) / pi<R>();
        CHECK(close(tanh_sinh::cauchy(density, Side::left, d).value, left, 2000));
        CHECK(close(tanh_sinh::cauchy(density, Side::right, d).value, right, 2000));
        CHECK(close(grid.cauchy(Side::left, d), left, 2000));
        CHECK(close(grid.cauchy(Side::right, d), right, 2000));
      }
      for (const R& x : {R(1e-3), R(0.3), R(0.7)}) {
        const Node<R> node = density[0].panel.node_from_left(x);
        const R expected = on_interval(a, x, node.from_right) / pi<R>();
        const R part = parts(a, {x, node.from_right});
        CHECK(close(tanh_sinh::hilbert(density, {0, node}).value, expected, 2000, part));
        CHECK(close(grid.hilbert({0, node}), expected, 2000, part));
      }
    }
  }
}

TEST_CASE("next to a = -1 the exponent's last digits count") {
  // int_0^1 y^a/(y + d) dy ~ 1/((1+a) d): the mass is at the end.
  const Power<double> a{-1, 1e-20};
  CHECK(close(left_of(a, 0.01), 1e22, 10));
  CHECK(close(right_of(a, 0.01), 1e20 / 1.01, 10));
  CHECK(close(on_interval(a, 0.25, 0.75), -4e20, 10));
  CHECK(close(on_interval(a, 0.75, 0.25), -4e20 / 3, 10));
}
