#include "symbolic/field/plain_formula.hpp"
#include "support/test.hpp"

using namespace steadyslide::symbolic;

TEST_CASE("names, accents, sides and powers") {
  CHECK(latex_of_plain("A_l |x|^lambda") == "A_- |x|^{\\lambda }");
  CHECK(latex_of_plain("alpha_r") == "\\alpha _+");
  CHECK(latex_of_plain("psi_bar'") == "\\bar\\psi '");
  CHECK(latex_of_plain("u_bar'") == "\\bar{u}'");
  CHECK(latex_of_plain("theta_12 >= 0") == "\\theta _{12} \\ge  0");
  CHECK(latex_of_plain("e^{2 i pi lambda}") == "e^{2 i \\pi  \\lambda }");
  CHECK(latex_of_plain("c_1 < ... < c_(k+1)") == "c_{1} < \\dots  < c_{k+1}");
  CHECK(latex_of_plain("log^2|x|/pi -> -infinity") == "\\log ^{2}|x|/\\pi  \\to  -\\infty ");
  CHECK(latex_of_plain("f_- z^-1 + oo") == "f_- z^{-1} + \\infty ");
  CHECK(latex_of_plain("x^lost") == "x^{\\mathrm{lost}}");
}

TEST_CASE("a sign that touches its name on the left alone is above it") {
  CHECK(latex_of_plain("Y+ = G Y-") == "Y^+ = G Y^-");
  CHECK(latex_of_plain("(F+ - F-)/(2i)") == "(F^+ - F^-)/(2i)");
  CHECK(latex_of_plain("Y+/Y-") == "Y^+/Y^-");
  CHECK(latex_of_plain("s+i - x") == "s+i - x");
}

TEST_CASE("sentences: formulas between backticks, all else escaped") {
  const char* sentence = "The amplitude `theta_1` of `d^lambda`, 50 % of it.";
  CHECK(without_marks(sentence) == "The amplitude theta_1 of d^lambda, 50 % of it.");
  CHECK(latex_sentence(sentence) == "The amplitude $\\theta _{1}$ of $d^{\\lambda }$, 50 \\% of it.");
  CHECK(latex_sentence("") == "");
  CHECK(latex_sentence("`t`") == "$t$");
}
