#include "symbolic/field/derivation.hpp"
#include "support/test.hpp"

using namespace steadyslide::symbolic;

namespace {

Derivation example() {
  Derivation d{"Friction jump at x = 0", {}};
  d.assume("Contact on both sides; 50 % of {all} #cases & more.", {"t = A |x|^l", "t = A |x|^\\lambda"});
  d.act("Insert it.");
  d.conclude("The power is `beta_k`.", {"l = beta", "\\lambda = \\beta"});
  return d;
}

}  // namespace

TEST_CASE("text: numbered steps, each with its kind, formulas on their own lines") {
  CHECK(to_text(example()) ==
        "Friction jump at x = 0\n----------------------\n"
        "1.  assume  Contact on both sides; 50 % of {all} #cases & more.\n"
        "                t = A |x|^l\n"
        "2.  do      Insert it.\n"
        "3.  find    The power is beta_k.\n"
        "                l = beta\n");
}

TEST_CASE("text: no line is longer than 100 columns unless a word is") {
  Derivation d{"Long", {}};
  std::string words = "word";
  for (int k = 0; k < 200; ++k) words += k % 7 == 0 ? " something" : " a";
  d.act(words, {words, ""});
  const std::vector<std::string> shown = lines(to_text(d));
  for (const std::string& line : shown) {
    CHECK(line.size() <= 100);
    CHECK(line.find_last_not_of(' ') + 1 == line.size());
  }
  CHECK(shown.size() > 8);
}

TEST_CASE("LaTeX: words are escaped, formulas among them are set, displayed ones stay") {
  const std::string latex = to_latex(example());
  CHECK(holds(latex, "50 \\% of \\{all\\} \\#cases \\& more."));
  CHECK(holds(latex, "The power is $\\beta _{k}$."));
  CHECK(holds(latex, "\\[ t = A |x|^\\lambda \\]"));
  const std::string document = latex_document({example(), example()});
  CHECK(document.starts_with("\\documentclass"));
  CHECK(document.ends_with("\\end{document}\n"));
}
