// Gauss-Jacobi rules, compared with moments in Gamma functions.

#include "enclosure/quadrature/jacobi_rule.hpp"
#include "support/enclosure_test.hpp"

namespace {

/// int (1+x)^(left+k) (1-x)^right dx.
Ball moment(const Ball& left, const Ball& right, int k) {
  const Ball a = left + (k + 1), b = right + 1;
  return power(Ball(2, a.bits()), a + b - 1) * gamma(a) * gamma(b) / gamma(a + b);
}

Ball sum_of_powers(const JacobiRule& rule, int k) {
  Ball sum(0, rule.mass.bits());
  for (std::size_t i = 0; i < rule.size(); ++i) sum += rule.weights[i] * power(rule.from_left[i], k);
  return sum;
}

/// Returns the rule's integral of (1+x)^k, which is at most 2^k on [-1, 1].
Ball integral_of_power(const JacobiRule& rule, int k) {
  return Ball::plus_or_minus(sum_of_powers(rule, k), rule.remainder(power(Ball(2, 64), k)));
}

/// Returns a power from -1 + 1e-12 to 3.
Rational random_power() {
  switch (uniform(0, 3)) {
    case 0: return Rational(two_to(-uniform(0, 40)) - 1);
    case 1: return Rational(uniform(0, 3));
    default: return Rational(Rational(uniform(-99, 199)) / 100);
  }
}

}  // namespace

TEST_CASE("moments of degree < 2n are contained, those of degree 2n are not") {
  for (const char* left : {"-0.999999", "-0.7", "-0.5", "0", "0.3", "1", "7"}) {
    for (const char* right : {"-0.999999", "-0.5", "0", "0.9", "2"}) {
      for (const int n : {1, 2, 3, 8, 31, 90}) {
        INFO("left = ", left, ", right = ", right, ", n = ", n);
        const Bits bits = 200;
        const Ball l(parse_rational(left), bits), r(parse_rational(right), bits);
        const JacobiRule rule(n, l, r, bits);
        for (const int k : {0, 1, n, 2 * n - 1}) {
          if (k >= 2 * n) continue;
          CHECK(integral_of_power(rule, k).overlaps(moment(l, r, k)));
          CHECK(integral_of_power(rule, k).radius() < abs(moment(l, r, k)) * Ball(two_to(-130), 64));
        }
        // The error of degree 2n is the squared norm of the monic polynomial, about 4^-n.
        if (n < 32) CHECK(!integral_of_power(rule, 2 * n).overlaps(moment(l, r, 2 * n)));
      }
    }
  }
}

TEST_CASE("one node next to either end") {
  for (const int exponent : {-10, -39, -40, -200}) {
    const Ball small(Rational(two_to(exponent) - 1), 900), large(1.07_r, 900);
    for (const Bits bits : {30, 200}) {
      const JacobiRule left(1, small, large, bits), right(1, large, small, bits);
      const Ball expected = Ball(2) * (small + 1) / (small + large + 2);
      CHECK(left.from_left[0].overlaps(expected));
      CHECK(right.from_right[0].overlaps(expected));
    }
  }
}

TEST_CASE("random rules") {
  CHECK(rc::check("moments", [] {
    const Bits bits = some_bits();
    const int n = uniform(1, 12);
    // With few bits a power near -1 would include -1.
    const Ball l(random_power(), 900), r(random_power(), 900);
    const JacobiRule rule(n, l, r, bits);
    const int k = uniform(0, 2 * n - 1);
    RC_ASSERT(integral_of_power(rule, k).overlaps(moment(l, r, k)));
    RC_ASSERT(rule.mass.overlaps(moment(l, r, 0)));
    const JacobiRule precise(n, l, r, 3 * bits);
    for (std::size_t i = 0; i < rule.size(); ++i) {
      RC_ASSERT(rule.weights[i].is_positive());
      RC_ASSERT(rule.from_left[i].overlaps(precise.from_left[i]));
      RC_ASSERT(rule.from_right[i].overlaps(precise.from_right[i]));
      RC_ASSERT(rule.weights[i].overlaps(precise.weights[i]));
      RC_ASSERT(arb_rel_accuracy_bits(rule.from_left[i].get()) > bits - 6);
      RC_ASSERT(arb_rel_accuracy_bits(rule.from_right[i].get()) > bits - 6);
    }
  }));
  CHECK(rc::check("wide powers: the moment at a point of them", [] {
    const Bits bits = some_bits();
    const Rational left = random_power(), right = random_power();
    const Rational radius = two_to(-uniform(10, 60)) * Rational(std::min(Rational(left + 1), Rational(right + 1)));
    const auto point = [&](const Rational& p) {
      return Ball(Rational(p + radius * Rational(uniform(-8, 8)) / 8), 600);
    };
    const int n = uniform(1, 12), k = uniform(0, 2 * n - 1);
    const JacobiRule rule(n, midpoint_and_radius(left, radius, bits), midpoint_and_radius(right, radius, bits), bits);
    RC_ASSERT(integral_of_power(rule, k).overlaps(moment(point(left), point(right), k)));
  }));
}

TEST_CASE("a start that is the node itself") {
  // The only node is (left - right)/(left + right + 2) = 1/2. The bound of its distance from the start comes from
  // rounding alone.
  for (const char* scale : {"0.51", "0.3", "1.7", "12.34567"}) {
    for (const Bits bits : {40, 60, 61, 80, 180, 400}) {
      const Ball once(parse_rational(scale), 4096);
      const JacobiRule rule(1, 3 * once - 1, once - 1, bits);
      CHECK(rule.from_left[0].overlaps(Ball(3_r / 2, bits)));
      CHECK(rule.from_left[0].radius() < Ball(two_to(-static_cast<int>(bits) + 4), 64));
    }
  }
}

TEST_CASE("Chebyshev's nodes, and Legendre's beside the recurrence's") {
  const Bits bits = 256;
  const int n = 40;
  const JacobiRule chebyshev(n, Ball(-1_r / 2, bits), Ball(-1_r / 2, bits), bits);
  for (int i = 0; i < n; ++i) {
    const Ball x = cos(Ball::pi(2 * bits) * (2 * (n - i) - 1) / (2 * n));
    CHECK(chebyshev.from_left[static_cast<std::size_t>(i)].overlaps(1 + x));
    CHECK(chebyshev.from_right[static_cast<std::size_t>(i)].overlaps(1 - x));
    CHECK(chebyshev.weights[static_cast<std::size_t>(i)].overlaps(Ball::pi(2 * bits) / n));
  }
  // Powers of 2^-200 use the general recurrence; Arb's rule is for powers of 0. The nodes agree to about as many bits.
  const Ball tiny(two_to(-200), 512);
  const JacobiRule legendre(n, 0, 0, bits), neighbour(n, tiny, tiny, bits);
  for (std::size_t i = 0; i < legendre.size(); ++i) {
    const Ball near(two_to(-180), 64);
    CHECK(Ball::plus_or_minus(legendre.from_left[i], near).contains(neighbour.from_left[i]));
    CHECK(Ball::plus_or_minus(legendre.weights[i], near).contains(neighbour.weights[i]));
  }
}

TEST_CASE("controls: the remainder is needed, and so is every node") {
  const Bits bits = 128;
  const Ball l(-3_r / 10, bits), r(2_r / 5, bits);
  // 1/(3-x) is at most 1/(3 - 5/3) in the ellipse rho = 3, whose axis is 5/3.
  const JacobiRule rule(6, l, r, bits), precise(60, l, r, bits);
  const auto sum = [](const JacobiRule& of) {
    Ball result(0, 128);
    for (std::size_t i = 0; i < of.size(); ++i) result += of.weights[i] / (2 + of.from_right[i]);
    return result;
  };
  const Ball bound(3_r / 4, bits), rho(3, bits);
  const Ball value = Ball::plus_or_minus(sum(precise), precise.remainder(bound, rho));
  CHECK(value.radius() < Ball(two_to(-100), 64));
  CHECK(!sum(rule).overlaps(value));
  CHECK(Ball::plus_or_minus(sum(rule), rule.remainder(bound, rho)).contains(value));
  for (std::size_t i = 0; i < rule.size(); ++i) {
    JacobiRule moved = rule;
    moved.from_left[i] += Ball(two_to(-100), bits);
    CHECK(!integral_of_power(moved, 1).overlaps(moment(l, r, 1)));
  }
  CHECK(integral_of_power(rule, 1).overlaps(moment(l, r, 1)));
}

TEST_CASE("what is no rule is refused") {
  const Bits bits = 64;
  CHECK_THROWS_AS(JacobiRule(0, 0, 0, bits), std::invalid_argument);
  CHECK_THROWS_AS(JacobiRule(3, Ball(-1), 0, bits), std::invalid_argument);
  CHECK_THROWS_AS(JacobiRule(3, 0, Ball::unknown(bits), bits), std::invalid_argument);
  CHECK_THROWS_AS(JacobiRule(3, 0, Ball::hull(Ball(-2), Ball(0)), bits), std::invalid_argument);
  const JacobiRule rule(3, 0, 0, bits);
  CHECK(!rule.remainder(1, 1).is_finite());
  CHECK(!rule.remainder(1, Ball::unknown(bits)).is_finite());
  CHECK(!rule.remainder(Ball::unknown(bits), 2).is_finite());
}

TEST_CASE("rules are made once") {
  JacobiRules rules(100);
  const Ball l(1_r / 3, 100);
  const JacobiRule& rule = rules(5, l, 0);
  CHECK(&rules(5, l, Ball(0, 100)) == &rule);
  CHECK(&rules(5, 0, l) != &rule);
  CHECK(&rules(6, l, 0) != &rule);
  CHECK(&rules(5, l.midpoint(), 0) != &rule);
  CHECK(rules.size() == 4);
}
