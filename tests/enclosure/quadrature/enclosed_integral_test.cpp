// Panels and the trapezoidal rule, compared with closed forms and with each other, and on random integrands.

#include "enclosure/quadrature/enclosed_integral.hpp"
#include "enclosure/quadrature/graded_panels.hpp"
#include "enclosure/quadrature/power_panel.hpp"
#include "support/enclosure_test.hpp"

namespace {

constexpr Route routes[] = {Route::panels, Route::trapezoidal};

/// A real number with any number of bits.
using Number = std::function<Ball(Bits)>;

Ball integral(const PowerIntegrand& integrand, std::size_t first, std::size_t last, Route route, Bits bits) {
  JacobiRules rules(bits);
  const EnclosedIntegral result = enclosed_integral(integrand, first, last, route, rules);
  INFO(result.refusal);
  CHECK(result.refusal.empty());
  return result.value;
}

/// Checks that the integral is finite, contains the value, and has about as many correct bits as requested.
void check(const PowerIntegrand& integrand, const Ball& value, Bits bits) {
  for (const Route route : routes) {
    CAPTURE(static_cast<int>(route));
    const Ball result = integral(integrand, 0, integrand.points.size() - 1, route, bits);
    CHECK(result.overlaps(value));
    CHECK(result.radius() < Ball(two_to(20 - static_cast<int>(bits)), 64));
  }
}

std::string refusal(const PowerIntegrand& integrand) {
  JacobiRules rules(64);
  std::string words;
  for (const Route route : routes) {
    const EnclosedIntegral result = enclosed_integral(integrand, 0, integrand.points.size() - 1, route, rules);
    CHECK(!result.value.is_finite());
    words = result.refusal;
  }
  return words;
}

/// Points that may be close, integrable powers, a polynomial, and possibly a pole.
struct RandomIntegrand {
  std::vector<Rational> points;
  std::vector<Rational> powers;
  std::vector<Rational> polynomial;
  std::optional<Rational> pole;
  std::size_t first;
  std::size_t last;

  RandomIntegrand() {
    const int n = uniform(2, 5);
    Rational x = Rational(uniform(-20, 20)) / 8;
    for (int j = 0; j < n; ++j) {
      points.push_back(x);
      x += uniform(0, 4) == 0 ? two_to(-uniform(0, 30)) : Rational(uniform(1, 20)) / 8;
      powers.push_back(uniform(0, 4) == 0 ? Rational(uniform(0, 2)) : Rational(uniform(-85, 150)) / 100);
    }
    first = static_cast<std::size_t>(uniform(0, n - 2));
    last = static_cast<std::size_t>(uniform(static_cast<int>(first) + 1, n - 1));
    for (int k = uniform(0, 3); k >= 0; --k) polynomial.push_back(Rational(uniform(-9, 9)) / 4);
    const Rational stretch = points[last] - points[first];
    if (uniform(0, 2) == 0) pole = points.back() + Rational(uniform(1, 40)) / 16;
    if (uniform(0, 2) == 0) pole = points[first] + stretch * Rational(uniform(1, 99)) / 100;
    if (pole && std::find(points.begin(), points.end(), *pole) != points.end()) pole.reset();
  }

  /// Returns the balls; a power may have a radius.
  PowerIntegrand at(Bits bits, const Rational& radius) const {
    PowerIntegrand result;
    result.polynomial.clear();
    for (const Rational& x : points) result.points.push_back(Ball(x, bits));
    for (const Rational& p : powers) result.powers.push_back(midpoint_and_radius(p, radius, bits));
    for (const Rational& c : polynomial) result.polynomial.push_back(Ball(c, bits));
    if (pole) result.pole = Ball(*pole, bits);
    return result;
  }

  RandomIntegrand moved(const Rational& radius) const {
    RandomIntegrand result = *this;
    for (Rational& p : result.powers) p += radius * Rational(uniform(-8, 8)) / 8;
    return result;
  }
};

}  // namespace

TEST_CASE("flat punch without jumps: Beta functions") {
  for (const Bits bits : {64, 166}) {
    for (const char* angle : {"0", "0.05", "0.3", "0.45"}) {
      const Ball a(parse_rational(angle), bits), half(1_r / 2, bits);
      // int (1+x)^-(1/2+a) (1-x)^-(1/2-a) = Gamma(1/2-a) Gamma(1/2+a) = pi/cos(pi a).
      check({{-1, 1}, {-half - a, a - half}}, Ball::pi(bits) / cos(Ball::pi(bits) * a), bits);
      // The first moment is -2 a times this.
      check({{-1, 1}, {-half - a, a - half}, {0, 1}}, -2 * a * Ball::pi(bits) / cos(Ball::pi(bits) * a), bits);
    }
  }
}

TEST_CASE("flat punch with jumps: the load is 1 however many there are") {
  const Bits bits = 120;
  const std::vector<Rational> slopes{1_r / 10, 6_r / 10, 0, 2, 1_r / 20, 1_r / 3};
  const std::vector<Rational> jumps{-9_r / 10, -1_r / 3, -33_r / 100, 1_r / 2, 999_r / 1000};
  for (std::size_t n = 0; n <= jumps.size(); ++n) {
    PowerIntegrand integrand;
    std::vector<Ball> angles;
    for (std::size_t k = 0; k <= n; ++k) angles.push_back(atan(Ball(slopes[k], bits)) / Ball::pi(bits));
    const Ball half(1_r / 2, bits);
    integrand.points.push_back(-1);
    integrand.powers.push_back(-half - angles[0]);
    for (std::size_t k = 0; k < n; ++k) {
      integrand.points.push_back(Ball(jumps[k], bits));
      integrand.powers.push_back(angles[k] - angles[k + 1]);
    }
    integrand.points.push_back(1);
    integrand.powers.push_back(angles[n] - half);
    for (const Route route : routes) {
      Ball load(0, bits);
      for (std::size_t k = 0; k <= n; ++k)
        load += cos(Ball::pi(bits) * angles[k]) * integral(integrand, k, k + 1, route, bits);
      CAPTURE(n);
      CHECK(load.overlaps(Ball::pi(2 * bits)));
      CHECK(load.radius() < Ball(two_to(-100), 64));
    }
  }
}

TEST_CASE("a published value, and other closed forms with a pole") {
  for (const Bits bits : {64, 166}) {
    const auto ball = [&](const Rational& x) { return Ball(x, bits); };
    // int dx/((x-2) ((1-x)(1+x)^3)^(1/4)) = -pi sqrt(2)/3^(3/4).
    check({{-1, 1}, {ball(-3_r / 4), ball(-1_r / 4)}, {1}, Ball(2)},
          -Ball::pi(bits) * sqrt(Ball(2, bits)) / power(Ball(3, bits), ball(3_r / 4)), bits);
    // PV int dx/(x-t) = log((1-t)/(1+t)); PV int (1-x^2)^(1/2)/(x-t) = -pi t; with -1/2 it is 0.
    for (const Rational& t : {0_r, 1_r / 2, -99_r / 100}) {
      check({{-1, 1}, {0, 0}, {1}, ball(t)}, log((1 - ball(t)) / (1 + ball(t))), bits);
      check({{-1, 1}, {ball(1_r / 2), ball(1_r / 2)}, {1}, ball(t)}, -Ball::pi(bits) * ball(t), bits);
      check({{-1, 1}, {ball(-1_r / 2), ball(-1_r / 2)}, {1}, ball(t)}, Ball(0), bits);
      // (1+x)^a (1-x)^-a/(x-t): pi/sin(pi a) - pi cot(pi a) ((1+t)/(1-t))^a.
      const Ball a = ball(3_r / 10), angle = Ball::pi(bits) * a;
      check({{-1, 1}, {a, -a}, {1}, ball(t)},
            Ball::pi(bits) / sin(angle) * (1 - cos(angle) * power((1 + ball(t)) / (1 - ball(t)), a)), bits);
    }
  }
}

TEST_CASE("random integrals") {
  CHECK(rc::check("p and 3p bits, both routes", [] {
    const RandomIntegrand random;
    const Bits bits = uniform(60, 80);  // with fewer bits some points cannot be separated from the pole
    const Ball panels = integral(random.at(bits, 0), random.first, random.last, Route::panels, bits);
    const Ball precise = integral(random.at(3 * bits, 0), random.first, random.last, Route::panels, 3 * bits);
    const Ball witness = integral(random.at(bits, 0), random.first, random.last, Route::trapezoidal, bits);
    RC_ASSERT(panels.overlaps(precise));
    RC_ASSERT(witness.overlaps(precise));
    RC_ASSERT(panels.overlaps(witness));
    RC_ASSERT(panels.radius() < Ball(1_r / 1000, 64) * (1 + abs(panels)));
  }));
  CHECK(rc::check("wide powers contain the value at a point of them", [] {
    const RandomIntegrand random;
    const Bits bits = uniform(60, 80);  // with fewer bits some points cannot be separated from the pole
    const Rational radius = two_to(-uniform(15, 60));
    for (const Route route : routes) {
      const Ball wide = integral(random.at(bits, radius), random.first, random.last, route, bits);
      const Ball point = integral(random.moved(radius).at(100, 0), random.first, random.last, Route::panels, 100);
      RC_ASSERT(wide.overlaps(point));
    }
  }));
}

TEST_CASE("gaps of 1e-80 and a principal value 1e-60 from a wedge") {
  const Bits bits = 333;
  const Ball tiny = power(Ball(10, bits), -80), near = power(Ball(10, bits), -60);
  const PowerIntegrand gap{{0, tiny, 1}, {Ball(1_r / 3, bits), Ball(-2_r / 5, bits), Ball(-1_r / 2, bits)}};
  CHECK(integral(gap, 1, 2, Route::panels, bits).overlaps(integral(gap, 1, 2, Route::trapezoidal, bits)));
  CHECK(integral(gap, 0, 1, Route::panels, bits).overlaps(integral(gap, 0, 1, Route::trapezoidal, bits)));
  const PowerIntegrand pole{{0, 1}, {Ball(1_r / 3, bits), Ball(-1_r / 2, bits)}, {1}, near};
  CHECK(integral(pole, 0, 1, Route::panels, bits).overlaps(integral(pole, 0, 1, Route::trapezoidal, bits)));
}

TEST_CASE("control: panels without their remainder") {
  const Bits bits = 128;
  JacobiRules rules(bits);
  const std::vector<OutsidePoint> outside{{Side::right, 1, Ball(-1)}};
  const auto one = [](const PowerPanel::Node&) { return Ball(1); };
  const PowerPanel rough(2, Ball(-3_r / 4, bits), Ball(-1_r / 4, bits), outside, 8, rules);
  const Ball value = Ball::pi(bits) * sqrt(Ball(2, bits)) / power(Ball(3, bits), Ball(3_r / 4, bits));
  CHECK(!rough.integral(one, 0).overlaps(value));
  CHECK(rough.integral(one, 1).contains(value));
  // The bound is not far above the true error.
  CHECK(rough.remainder(1) < 1000 * abs(rough.integral(one, 0) - value));
}

TEST_CASE("graded panels fill the interval and keep their distance") {
  CHECK(rc::check([] {
    const Bits bits = 100;
    std::vector<OutsidePoint> outside;
    for (int k = uniform(0, 4); k > 0; --k) {
      outside.push_back(
          {uniform(0, 1) == 0 ? Side::left : Side::right, Ball(two_to(-uniform(-3, 200)), bits), Ball(uniform(-1, 1))});
    }
    const Ball length(Rational(uniform(1, 99), 7), bits), left(Rational(uniform(-1, 1), 2), bits),
        right(Rational(uniform(-1, 1), 2), bits);
    Ball end(0, bits);
    for (const GradedPanel& panel : graded(length, left, right, outside)) {
      RC_ASSERT(panel.from_left.overlaps(end));
      end = panel.from_left + panel.length;
      RC_ASSERT((end + panel.from_right).overlaps(length));
      for (const OutsidePoint& point : panel.outside) RC_ASSERT(point.distance > panel.length * Ball(2_r / 5, 64));
      RC_ASSERT(PowerPanel::count_for(bits, panel.length, panel.outside) > 0);
      RC_ASSERT(PowerPanel::count_for(bits, panel.length, panel.outside) < 100);
    }
    RC_ASSERT(end.overlaps(length));
  }));
}

TEST_CASE("what is not integrable or not holomorphic is refused, in words") {
  const Ball half(1_r / 2, 64), wide = Ball::hull(Ball(-1), Ball(1));
  CHECK(refusal({{0, 1}, {-1, 0}}) == "the power at point 0 is not certainly above -1");
  CHECK(refusal({{0, half, 1}, {0, Ball(-3_r / 2, 64), 0}}) == "the power at point 1 is not certainly above -1");
  CHECK(refusal({{0, 1}, {0, wide - half}}) == "the power at point 1 is not certainly above -1");
  CHECK(refusal({{1, 0}, {0, 0}}) == "points 0 and 1 are not in order");
  CHECK(refusal({{0, half, half}, {0, 0, 0}}) == "points 1 and 2 are not in order");
  CHECK(refusal({{0, wide}, {0, 0}}) == "points 0 and 1 are not in order");
  CHECK(refusal({{0, 1}, {half, half}, {1}, Ball(1)}) == "the pole is not certainly away from point 1");
  CHECK(refusal({{0, half, 1}, {0, 0, 0}, {1}, half}) == "the pole is not certainly away from point 1");
  CHECK(refusal({{0, 1}, {half, half}, {1}, wide}) == "the pole is not certainly away from point 0");
  CHECK(refusal({{0, 1}, {0, Ball::unknown(64)}}) == "a number is not finite");
  CHECK(refusal({{0, 1}, {0, 0}, {1}, Ball::unknown(64)}) == "a number is not finite");
  JacobiRules rules(64);
  CHECK_THROWS_AS(enclosed_integral({{0, 1}, {0, 0}}, 1, 1, Route::panels, rules), std::invalid_argument);
  CHECK_THROWS_AS(enclosed_integral({{0, 1}, {0}}, 0, 1, Route::panels, rules), std::invalid_argument);
}
