#include "symbolic/field/rational_function.hpp"
#include "support/test.hpp"

using namespace steadyslide::symbolic;
using GiNaC::ex;
using GiNaC::symbol;

namespace {

/// A random polynomial of at most four terms, never zero.
ex polynomial(const std::vector<symbol>& symbols) {
  ex sum = 0;
  while (sum.expand().is_zero()) {
    for (int terms = uniform(1, 4); terms > 0; --terms) {
      ex term = ex(uniform(-9, 9)) / uniform(1, 9);
      for (const symbol& x : symbols) term *= GiNaC::pow(x, uniform(0, 2));
      sum += term;
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("equality of rational functions is decided, and a near miss is not taken for it") {
  const std::vector<symbol> symbols{symbol("x"), symbol("y"), symbol("z")};
  const ex tiny = GiNaC::pow(ex(10), -200);
  CHECK(rc::check([&] {
    const ex a = polynomial(symbols), b = polynomial(symbols), c = polynomial(symbols), d = polynomial(symbols);
    const ex lhs = a / b + c / d, rhs = (a * d + c * b) / (b * d);
    RC_ASSERT(decide_equal(lhs, rhs).identical);
    RC_ASSERT(decide_equal(lhs, rhs.expand()).identical);
    RC_ASSERT(decide_equal(1 / (a / b), b / a).identical);
    RC_ASSERT(canonical_text(lhs) == canonical_text(rhs));
    RC_ASSERT(!decide_equal(lhs, rhs + tiny).identical);
    RC_ASSERT(!decide_equal(lhs, rhs + tiny * symbols[1] / a).identical);
    RC_ASSERT(canonical_text(lhs) != canonical_text(rhs + tiny));
  }));
}

TEST_CASE("what is no rational function is refused, not answered") {
  const symbol x("x");
  CHECK_THROWS_AS(decide_equal(GiNaC::pow(GiNaC::sin(x), 2) + GiNaC::pow(GiNaC::cos(x), 2), 1), std::domain_error);
  CHECK_THROWS_AS(decide_equal(GiNaC::sqrt(ex(2)) * GiNaC::sqrt(ex(3)), GiNaC::sqrt(ex(6))), std::domain_error);
  CHECK_THROWS_AS(decide_equal(GiNaC::Pi, GiNaC::Pi + x), std::domain_error);
  CHECK_THROWS_AS(decide_equal(x, ex(0.5)), std::domain_error);
  CHECK_THROWS_AS(decide_equal(x, GiNaC::I * x), std::domain_error);
  CHECK_THROWS_AS(decide_equal(GiNaC::pow(ex(2), x), x), std::domain_error);
  CHECK_FALSE(is_rational_function(GiNaC::pow(x, ex(1) / 2)));
  CHECK(is_rational_function(GiNaC::pow(1 + 1 / x, -3)));
}

TEST_CASE("a hidden division by zero is refused") {
  const symbol x("x");
  const ex zero = GiNaC::pow(x + 1, 2) - x * x - 2 * x - 1;
  CHECK_THROWS_AS(decide_equal(1 / zero, 1), std::domain_error);
  CHECK_THROWS_AS(decide_equal(1 / (1 + 1 / zero), 1), std::domain_error);
  CHECK_THROWS_AS(canonical_text(x / zero), std::domain_error);
}

TEST_CASE("divisors are recorded, those that cancel too") {
  const symbol x("x"), y("y");
  const RationalDecision decision = decide_equal((x * x - y * y) / (x - y), x + y);
  CHECK(decision.identical);
  CHECK(decision.nonvanishing == std::set<std::string>{"x - y"});
  CHECK(decide_equal(1 / (1 + 1 / x), x / (1 + x)).nonvanishing == std::set<std::string>{"x", "x + 1"});
  CHECK(decide_equal(1 / (6 * y - 4 * x), 1).nonvanishing == std::set<std::string>{"2*x - 3*y"});
  CHECK(decide_equal(1 / (GiNaC::pow(x + 1, 2) - GiNaC::pow(x - 1, 2)), 1).nonvanishing == std::set<std::string>{"x"});
  CHECK(decide_equal(x / 2, x / 2).nonvanishing.empty());
}

TEST_CASE("canonical text: lowest terms, one sign, the order of the names") {
  // Many symbols: an order by address would differ from the order by name in some of them.
  std::vector<symbol> shuffled;
  for (const char* name : {"e", "b", "d", "a", "c"}) shuffled.emplace_back(name);
  ex sum = 0;
  for (const symbol& s : shuffled) sum += s;
  CHECK(canonical_text(sum) == "a + b + c + d + e");
  const symbol x("x"), y("y");
  CHECK(canonical_text(0 * x) == "0");
  CHECK(canonical_text(ex(-3) / 6) == "(-1)/(2)");
  CHECK(canonical_text((1 - 2 * x) / (2 * (1 - x))) == "(2*x - 1)/(2*x - 2)");
  CHECK(canonical_text((x * x - y * y) / (2 * y - 2 * x)) == "(-x - y)/(2)");
  CHECK(canonical_text(1 + x + y * y + x * y + x * x) == "x^2 + x*y + y^2 + x + 1");
  CHECK(canonical_text((6 * x + 4) / (4 * y + 2)) == "(3*x + 2)/(2*y + 1)");
  CHECK(canonical_text((x / 2 + ex(1) / 3) / (y / 6)) == "(3*x + 2)/(y)");
  CHECK_THROWS_AS(canonical_text(x + symbol("x")), std::domain_error);
}

TEST_CASE("limits at infinity") {
  const symbol x("x"), y("y");
  CHECK(limit_at_infinity((2 * x * y + 1) / (x + y), x).is_equal(2 * y));
  CHECK(limit_at_infinity(y / x, x).is_zero());
  CHECK(limit_at_infinity((x - x) * y, x).is_zero());
  CHECK_THROWS_AS(limit_at_infinity(x, x), std::domain_error);
}
