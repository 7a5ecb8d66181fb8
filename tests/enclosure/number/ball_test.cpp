// Infinite balls and NaN, and Arb's notation.

#include "model/invalid_data.hpp"
#include "support/enclosure_test.hpp"

TEST_CASE("what is not finite passes no test") {
  const Ball unknown = Ball::unknown(64), one(1, 64);
  std::vector<Ball> balls{unknown,
                          log(Ball(-1, 64)),
                          log(Ball(0, 64)),
                          sqrt(Ball(-2, 64)),
                          one / Ball(0, 64),
                          gamma(Ball(-1, 64)),
                          power(Ball(-1, 64), Ball(Rational(1, 2), 64)),
                          power(Ball(0, 64), Ball(0, 64)),
                          power(unknown, one),
                          power(one, unknown),
                          Ball::exactly(std::numeric_limits<double>::quiet_NaN(), 64),
                          Ball::exactly(std::numeric_limits<double>::infinity(), 64),
                          Ball::plus_or_minus(one, unknown),
                          Ball::around(one, unknown),
                          Ball::hull(one, unknown),
                          one.intersection(Ball(2, 64))};
  for (std::size_t k = 0; k < balls.size(); ++k) {
    CAPTURE(k);
    const Ball& ball = balls[k];
    CHECK(!ball.is_finite());
    for (const Ball& other : {one, unknown, ball}) {
      CHECK(!ball.contains(other));
      CHECK(!other.contains(ball));
      CHECK(!ball.contains_inside(other));
      CHECK(!other.contains_inside(ball));
      CHECK(!ball.overlaps(other));
      CHECK(!other.overlaps(ball));
      CHECK(!(ball < other));
      CHECK(!(ball > other));
      CHECK(!(ball <= other));
      CHECK(!(ball >= other));
    }
    CHECK(!ball.contains(1_r));
    CHECK(!ball.is_positive());
    CHECK(!ball.is_negative());
    CHECK(ball.contains_zero());
    CHECK(!(ball + one).is_finite());
    CHECK(!(ball * one).is_finite());
  }
}

TEST_CASE("a whole number by itself has 64 bits, and the precision of what it meets") {
  CHECK(sqrt(Ball(2)).radius() < Ball(two_to(-60), 64));
  CHECK((Ball(1) / Ball(3, 500)).radius() < Ball(two_to(-490), 64));
  CHECK((Ball(1, 30) / Ball(3, 500)).bits() == 500);
  CHECK(power(Ball(7), 2).contains(Ball(49)));
}

TEST_CASE("balls are read as they were written, and nothing else is") {
  for (const Ball& ball : {Ball(0), Ball(-7), Ball(1_r / 3, 100), Ball::pi(1000),
                           Ball::plus_or_minus(0, Ball(1_r / 7, 64)), power(Ball(10, 200), -300)}) {
    const Ball read = Ball::load(ball.dump(), 100);
    CHECK(read.contains(ball));
    CHECK(ball.contains(read));
    CHECK(read.dump() == ball.dump());
    CHECK(read.bits() == 100);
  }
  const std::string unknown = Ball::unknown(64).dump();
  const char *const long_radius = "1 0 fffffffffffffffff 0", *const far = "1 0 1 fffffffffffffff";
  for (const char* text : {"",         "zz",        "1 2",      "1 2 3",        "1 2 3 4 5",      "1 0 1",
                           "1 0 1 0 ", " 1 0 1 0",  "1  0 1 0", "1 0 -1 0",     "1 0 40000000 0", "2 0 1 0",
                           "1 0 0 5",  "0 5 1 0",   "00 0 1 0", "-0 0 1 0",     "1.5 0 0 0",      "nan",
                           "F 0 1 0",  long_radius, far,        unknown.c_str()}) {
    CHECK_THROWS_AS(Ball::load(text, 64), InvalidData);
  }
}
