// Containment, with FLINT's way of testing: every function of Ball on random balls. The result at p bits and the one at
// 3p bits overlap, and the value at an exact point of the operands is in both. If the operands are in the domain, the
// result is finite; so NaN does not pass.

#include <functional>

#include "support/enclosure_test.hpp"

namespace {

using Unary = std::function<Ball(const Ball&)>;
using Binary = std::function<Ball(const Ball&, const Ball&)>;

/// Checks that the operands have this result at exact points inside them.
void contains_value(const Ball& result, const Ball& precise, const Ball& value) {
  RC_ASSERT(result.is_finite());
  RC_ASSERT(precise.is_finite());
  RC_ASSERT(value.is_finite());
  RC_ASSERT(result.overlaps(precise));
  RC_ASSERT(result.overlaps(value));
  RC_ASSERT(precise.overlaps(value));
}

void is_contained(const Unary& f, int low, int high) {
  const Bits bits = some_bits();
  const Sample x = sample(low, high, bits);
  contains_value(f(x.ball), f(x.ball.at(3 * bits)), f(tight(x.point, bits)));
}

void is_contained(const Binary& f, int low_x, int high_x, int low_y, int high_y) {
  const Bits bits = some_bits();
  const Sample x = sample(low_x, high_x, bits), y = sample(low_y, high_y, bits);
  contains_value(f(x.ball, y.ball), f(x.ball.at(3 * bits), y.ball.at(3 * bits)),
                 f(tight(x.point, bits), tight(y.point, bits)));
}

}  // namespace

TEST_CASE("arithmetic contains the rational result") {
  CHECK(rc::check([] {
    const Bits bits = some_bits();
    const Sample x = sample(-9, 9, bits), y = sample(-9, 9, bits);
    RC_ASSERT((x.ball + y.ball).contains(Rational(x.point + y.point)));
    RC_ASSERT((x.ball - y.ball).contains(Rational(x.point - y.point)));
    RC_ASSERT((x.ball * y.ball).contains(Rational(x.point * y.point)));
    RC_ASSERT((-x.ball).contains(Rational(-x.point)));
    RC_ASSERT(abs(x.ball).contains(Rational(abs(x.point))));
    RC_ASSERT(min(x.ball, y.ball).contains(std::min(x.point, y.point)));
    RC_ASSERT(max(x.ball, y.ball).contains(std::max(x.point, y.point)));
    const Ball quotient = x.ball / y.ball;
    RC_ASSERT(quotient.is_finite() != y.ball.contains_zero());
    if (quotient.is_finite()) RC_ASSERT(quotient.contains(Rational(x.point / y.point)));
    const int n = uniform(0, 9);
    Rational exact = 1;
    for (int k = 0; k < n; ++k) exact *= x.point;
    RC_ASSERT(power(x.ball, n).contains(exact));
    // The power of a ball that nearly touches 0 may reach 0 by rounding.
    const Ball reciprocal = power(x.ball, -n);
    RC_ASSERT(reciprocal.is_finite() != power(x.ball, n).contains_zero());
    if (reciprocal.is_finite()) RC_ASSERT(reciprocal.contains(Rational(1 / exact)));
  }));
}

TEST_CASE("what a ball says of itself") {
  CHECK(rc::check([] {
    const Bits bits = some_bits();
    const Sample x = sample(-9, 9, bits), y = sample(-9, 9, bits);
    RC_ASSERT(x.ball.contains(x.point));
    RC_ASSERT(x.ball.contains(x.ball.midpoint()));
    RC_ASSERT(x.ball.lower() <= x.ball);
    RC_ASSERT(x.ball <= x.ball.upper());
    RC_ASSERT(Ball::plus_or_minus(x.ball.midpoint(), x.ball.radius()).contains(x.point));
    RC_ASSERT(Ball::hull(x.ball, y.ball).contains(x.point));
    RC_ASSERT(Ball::hull(x.ball, y.ball).contains(y.point));
    RC_ASSERT(Ball::plus_or_minus(x.ball, y.ball).contains(Rational(x.point + y.point)));
    RC_ASSERT(Ball::plus_or_minus(x.ball, y.ball).contains(Rational(x.point - y.point)));
    RC_ASSERT(Ball::around(x.ball, abs(y.ball)).contains(x.ball.midpoint()));
    RC_ASSERT(x.ball.intersection(Ball::hull(x.ball, y.ball)).contains(x.point));
    if (!x.ball.overlaps(y.ball)) RC_ASSERT(!x.ball.intersection(y.ball).is_finite());
    // A decided comparison is true of every point.
    if (x.ball < y.ball) RC_ASSERT(x.point < y.point);
    if (x.ball <= y.ball) RC_ASSERT(x.point <= y.point);
    if (x.ball.is_positive()) RC_ASSERT(x.point > 0);
    if (x.ball.is_negative()) RC_ASSERT(x.point < 0);
    if (x.ball.contains(y.ball)) RC_ASSERT(x.ball.contains(y.point));
    if (x.ball.contains_inside(y.ball)) RC_ASSERT(x.ball.lower() < y.ball);
    if (!x.ball.overlaps(y.ball)) RC_ASSERT(x.point != y.point);
    const Ball read = Ball::load(x.ball.dump(), bits);
    RC_ASSERT(read.contains(x.ball));
    RC_ASSERT(x.ball.contains(read));
  }));
}

TEST_CASE("functions contain their values") {
  struct Row {
    const char* name;
    Unary function;
    int low, high;
  };
  const Ball little = Ball(Rational(1, 1000), 4096).upper();
  for (const auto& [name, f, low, high] : {Row{"exp", [](const Ball& x) { return exp(x); }, -40, 40},
                                           Row{"sin", [](const Ball& x) { return sin(x); }, -40, 40},
                                           Row{"cos", [](const Ball& x) { return cos(x); }, -40, 40},
                                           Row{"atan", [](const Ball& x) { return atan(x); }, -40, 40},
                                           Row{"sqrt", [&](const Ball& x) { return sqrt(x + little); }, 0, 40},
                                           Row{"log", [&](const Ball& x) { return log(x + little); }, 0, 40},
                                           Row{"gamma", [&](const Ball& x) { return gamma(x + little); }, 0, 20},
                                           Row{"pi", [](const Ball& x) { return x * Ball::pi(x.bits()); }, -2, 2}}) {
    CHECK(rc::check(name, [&, f = f, low = low, high = high] { is_contained(f, low, high); }));
  }
}

TEST_CASE("powers contain their values, next to 0 too") {
  const Binary f = [](const Ball& x, const Ball& p) { return power(x, p); };
  CHECK(rc::check("base > 0",
                  [&] { is_contained([&](const Ball& x, const Ball& p) { return f(x + 1, p); }, 0, 9, -3, 3); }));
  CHECK(rc::check("base >= 0, power > 0", [&] {
    const Bits bits = some_bits();
    const Sample x = sample(0, 2, bits), p = sample(0, 3, bits);
    if (!p.ball.is_positive()) return;
    contains_value(f(x.ball, p.ball), f(x.ball.at(3 * bits), p.ball.at(3 * bits)),
                   f(tight(x.point, bits), tight(p.point, bits)));
  }));
  CHECK(rc::check("base that reaches 0, power <= 0", [&] {
    const Bits bits = some_bits();
    const Ball x = Ball::hull(Ball(0, bits), abs(sample(-2, 2, bits).ball));
    RC_ASSERT(!power(x, -abs(sample(-2, 2, bits).ball)).is_finite());
  }));
}

TEST_CASE("exponents contain their values") {
  CHECK(rc::check([] {
    const Bits bits = some_bits();
    const Rational slope(uniform(-400, 400), uniform(1, 100));
    const Exponent exponent = Exponent(Rational(uniform(-4, 4), 4)) + Exponent::angle(slope);
    const Ball direct = Ball(exponent.offset(), 3 * bits) + atan(Ball(slope, 3 * bits)) / Ball::pi(3 * bits);
    contains_value(Ball(exponent, bits), Ball(exponent, 3 * bits), direct);
  }));
}

TEST_CASE("control: a ball moved by its width is found out") {
  CHECK(rc::check([] {
    const Bits bits = some_bits();
    const Sample x = sample(1, 9, bits);
    const Ball right = exp(x.ball), moved = right + 2 * right.radius() + right * Ball(two_to(-20), 64);
    RC_ASSERT(!moved.overlaps(exp(tight(x.point, bits))));
  }));
}
