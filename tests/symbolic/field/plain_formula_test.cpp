#include "symbolic/field/plain_formula.hpp"
#include "support/test.hpp"

using namespace steadyslide::symbolic;

TEST_CASE("names, accents, sides, powers and signs") {
  const auto formulas = pairs_of(STEADYSLIDE_TESTS "/symbolic/field/plain_formulas.txt");
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
