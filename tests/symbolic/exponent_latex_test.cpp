#include <doctest/doctest.h>

#include "model/singular_point.hpp"
#include "symbolic/field/exponent_expression.hpp"

using namespace steadyslide;
using symbolic::latex;

TEST_CASE("exponents print as LaTeX, one text for one exponent") {
  CHECK(latex(Exponent()) == "0");
  CHECK(latex(Exponent(Rational(-1, 2))) == R"(-\frac{1}{2})");
  CHECK(latex(Exponent(1)) == "1");
  CHECK(latex(edge_exponent(End::left, Rational(3, 35))) == R"(-\frac{1}{2}-\frac{1}{\pi}\arctan\frac{3}{35})");
  CHECK(latex(free_exponent(End::right, Rational(3, 35))) == R"(\frac{1}{2}+\frac{1}{\pi}\arctan\frac{3}{35})");
  CHECK(latex(jump_exponent(Rational(1, 3), Rational(2))) ==
        R"(\frac{1}{\pi}\arctan\frac{1}{3}-\frac{1}{\pi}\arctan 2)");
  CHECK(latex(jump_exponent(Rational(-1, 3), Rational(2))) ==
        R"(-\frac{1}{\pi}\arctan\frac{1}{3}-\frac{1}{\pi}\arctan 2)");
  CHECK(latex(Exponent::angle(2) + Exponent::angle(2) + Exponent::angle(2)) == R"(\frac{3}{\pi}\arctan 2)");
  CHECK(latex(jump_exponent(2, 2)) == "0");
}

TEST_CASE("fractions print in lowest terms, the sign in front") {
  CHECK(latex(Rational(0)) == "0");
  CHECK(latex(Rational(-7)) == "-7");
  CHECK(latex(Rational(6, 4)) == R"(\frac{3}{2})");
  CHECK(latex(Rational(-6, 4)) == R"(-\frac{3}{2})");
}
