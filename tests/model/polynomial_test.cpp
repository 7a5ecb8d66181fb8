#include "model/polynomial.hpp"
#include "support/test.hpp"

namespace {

Rational random_rational() { return Rational(uniform(-20, 20), uniform(1, 9)); }

Polynomial random_polynomial() {
  std::vector<Rational> coefficients;
  for (int k = uniform(0, 5); k > 0; --k) coefficients.push_back(random_rational());
  return Polynomial(std::move(coefficients));
}

}  // namespace

TEST_CASE("polynomials form a commutative ring, and evaluation respects it") {
  CHECK(rc::check([] {
    const Polynomial a = random_polynomial(), b = random_polynomial(), c = random_polynomial();
    const Rational x = random_rational();
    const Polynomial zero;
    const Polynomial one = Polynomial::constant(1);
    RC_ASSERT(a + b == b + a);
    RC_ASSERT(a * b == b * a);
    RC_ASSERT((a + b) + c == a + (b + c));
    RC_ASSERT((a * b) * c == a * (b * c));
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT(a + zero == a);
    RC_ASSERT(a * one == a);
    RC_ASSERT(a * zero == zero);
    RC_ASSERT(a - a == zero);
    RC_ASSERT((a - b) + b == a);
    RC_ASSERT((a + b)(x) == a(x) + b(x));
    RC_ASSERT((a * b)(x) == a(x) * b(x));
    RC_ASSERT((a * b).derivative() == a.derivative() * b + a * b.derivative());
    RC_ASSERT((a - b).derivative() == a.derivative() - b.derivative());
    if (a != zero && b != zero) RC_ASSERT((a * b).degree() == a.degree() + b.degree());
  }));
}

TEST_CASE("a polynomial in another coordinate") {
  CHECK(Polynomial({1, -2, 3}).composed(2, 5) == Polynomial({66, 56, 12}));
  CHECK(Polynomial({1, -2, 3}).composed(0, 5) == Polynomial::constant(66));
  CHECK(rc::check([] {
    const Polynomial p = random_polynomial(), q = random_polynomial();
    const Rational a = random_rational(), b = random_rational(), c = random_rational(), d = random_rational();
    RC_ASSERT(p.composed(a, b)(c) == p(a * c + b));
    RC_ASSERT(p.composed(a, b).composed(c, d) == p.composed(a * c, a * d + b));
    RC_ASSERT((p * q).composed(a, b) == p.composed(a, b) * q.composed(a, b));
    RC_ASSERT(p.composed(a, b).derivative() == Polynomial::constant(a) * p.derivative().composed(a, b));
    RC_ASSERT(p.composed(1, 0) == p);
  }));
}

TEST_CASE("zeros at the top are dropped") {
  CHECK(Polynomial().degree() == -1);
  CHECK(Polynomial({0, 0}) == Polynomial());
  CHECK(Polynomial::constant(0).degree() == -1);
  CHECK(Polynomial({1, 2, 0}).degree() == 1);
  CHECK((Polynomial({1, 2, 3}) - Polynomial({0, 0, 3})).degree() == 1);
  CHECK(Polynomial({1, 2}).coefficient(7) == 0);
  CHECK(Polynomial()(5) == 0);
  CHECK(Polynomial::constant(3).derivative() == Polynomial());
  CHECK(Polynomial({1, 2, 3}).derivative() == Polynomial({2, 6}));
  CHECK(Polynomial({1, -2, 3})(0.5_r) == 0.75_r);
}

TEST_CASE("polynomials as text") {
  CHECK(to_string(Polynomial()) == "0");
  CHECK(to_string(Polynomial({0, 1})) == "x");
  CHECK(to_string(Polynomial({0, -1, 0.5_r})) == "0.5*x^2 - x");
  CHECK(to_string(Polynomial({Rational(-1, 3), 0, 0, -1})) == "-x^3 - 1/3");
  CHECK(to_string(Polynomial({1})) == "1");
  CHECK(to_string(Polynomial({-1, Rational(2, 3)})) == "2/3*x - 1");
}
