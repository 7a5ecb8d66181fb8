// Plain formulas, exponents and fractions in LaTeX.

#include "symbolic/field/plain_formula.hpp"
#include "model/singular_point.hpp"
#include "support/rows.hpp"
#include "symbolic/field/exponent_expression.hpp"

using namespace steadyslide::symbolic;

TEST_CASE("names, accents, sides, powers and signs") {
  // A sign that touches its name only on the left stands above the name.
  const auto formulas = rows_of(STEADYSLIDE_TESTS "/symbolic/field/plain_formulas.json");
  CHECK(formulas.size() >= 14);
  for (const auto& [plain, latex] : formulas) CHECK(latex_of_plain(plain) == latex);
}

TEST_CASE("sentences: formulas between backticks, all else escaped") {
  const char* sentence = "The amplitude `theta_1` of `d^lambda`, 50 % of it.";
  CHECK(without_marks(sentence) == "The amplitude theta_1 of d^lambda, 50 % of it.");
  CHECK(latex_sentence(sentence) == "The amplitude $\\theta _{1}$ of $d^{\\lambda }$, 50 \\% of it.");
  CHECK(latex_sentence("") == "");
  CHECK(latex_sentence("`t`") == "$t$");
}

TEST_CASE("exponents print as LaTeX, one text for one exponent") {
  CHECK(latex(Exponent()) == "0");
  CHECK(latex(Exponent(-0.5_r)) == R"(-\frac{1}{2})");
  CHECK(latex(Exponent(1)) == "1");
  CHECK(latex(edge_exponent(End::left, Rational(3, 35))) == R"(-\frac{1}{2}-\frac{1}{\pi}\arctan\frac{3}{35})");
  CHECK(latex(free_exponent(End::right, Rational(3, 35))) == R"(\frac{1}{2}+\frac{1}{\pi}\arctan\frac{3}{35})");
  CHECK(latex(jump_exponent(Rational(1, 3), 2_r)) == R"(\frac{1}{\pi}\arctan\frac{1}{3}-\frac{1}{\pi}\arctan 2)");
  CHECK(latex(jump_exponent(Rational(-1, 3), 2_r)) == R"(-\frac{1}{\pi}\arctan\frac{1}{3}-\frac{1}{\pi}\arctan 2)");
  CHECK(latex(Exponent::angle(2) + Exponent::angle(2) + Exponent::angle(2)) == R"(\frac{3}{\pi}\arctan 2)");
  CHECK(latex(jump_exponent(2, 2)) == "0");
}

TEST_CASE("fractions print in lowest terms, the sign in front") {
  CHECK(latex(0_r) == "0");
  CHECK(latex(Rational(-7)) == "-7");
  CHECK(latex(1.5_r) == R"(\frac{3}{2})");
  CHECK(latex(-1.5_r) == R"(-\frac{3}{2})");
}
