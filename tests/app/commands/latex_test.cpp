// A LaTeX table compiles. This needs pdflatex; if it is absent, the test says so and checks only the text.

#include <regex>

#include "app/command_line.hpp"

namespace {

/// Compiles t.tex of the folder.
void compile(const TemporaryFolder& folder, bool fits) {
  if (run_other({"sh", "-c", "command -v pdflatex"}, folder.path()).code != 0) {
    MESSAGE("pdflatex is absent: not compiled");
    return;
  }
  const Finished latex = run_other({"pdflatex", "-interaction=nonstopmode", "-halt-on-error", "t.tex"}, folder.path());
  CHECK_MESSAGE(latex.code == 0, latex.out);
  if (fits) CHECK_FALSE(holds(latex.out, "Overfull \\hbox"));
  CHECK(std::filesystem::exists(folder.path() / "t.pdf"));
}

/// Returns the prose of a document, and its formulas: the text between dollars or in displays.
std::pair<std::string, std::string> parts(const std::string& document) {
  std::string prose, formulas, text = document.substr(document.find("\\begin{document}"));
  const std::regex formula("\\$[^$]*\\$|\\\\\\[[^]*?\\\\\\]");
  for (std::smatch match; std::regex_search(text, match, formula); text = match.suffix()) {
    prose += match.prefix().str() + " ";
    formulas += match.str() + "\n";
  }
  return {prose + text, formulas};
}

/// Checks that formulas are set as formulas, also in the prose, and that every name has its sign.
void check_notation(const std::string& document) {
  const auto [prose, formulas] = parts(document);
  const std::regex in_prose(
      "[_^<>=|]|\\\\text(less|greater|bar|asciicircum)|\\b(theta|lambda|alpha|psi|sigma|Phi|pi|cos|cot|log)\\b");
  const std::regex in_formulas(
      "(^|[^\\\\A-Za-z])(theta|lambda|alpha|psi|sigma|Phi|pi|cos|sin|cot|log|arctan|sqrt|infinity)(?![A-Za-z])"
      "|<=|>=|\\*|_bar|_l|_r|_\\{[lr]\\}");
  for (const auto& [text, wrong] : {std::pair(prose, in_prose), {formulas, in_formulas}}) {
    std::smatch match;
    const bool found = std::regex_search(text, match, wrong);
    const std::string before = match.prefix();
    CHECK_MESSAGE(!found, before.substr(before.size() - std::min<std::size_t>(before.size(), 60))
                              << " >> " << match.str());
  }
  CHECK(holds(formulas, "\\lambda"));
}

void check_compiles(const Arguments& arguments, const std::string& input = "",
                    const std::string& last_environment = "longtable") {
  const TemporaryFolder folder;
  REQUIRE(folder.run(joined(arguments, {"--format", "latex", "-o", "t.tex"}), input).code == 0);
  const std::string text = folder.read("t.tex");
  CHECK(text.starts_with("\\documentclass{article}\n"));
  CHECK(text.ends_with("\\end{" + last_environment + "}\n\\end{document}\n"));
  if (last_environment == "enumerate") check_notation(text);
  compile(folder, last_environment == "longtable");
}

}  // namespace

TEST_CASE("tables compile, narrow and wide") {
  check_compiles(words("table --poisson=-0.5:0.45:0.05 --rear 0:2:0.5 --front 0,1e-30,1.5"));
  check_compiles(words("table --poisson 0.3 --rear 0.1 --front 0.2 --digits 100"));
  check_compiles(words("table --poisson 0 --rear 0 --front 0 --digits 1"));
}

TEST_CASE("exponents compile") { check_compiles({"exponents", "-", "--digits", "50"}, problem_text("four_pieces")); }

TEST_CASE("derivations compile: jumps, a wedge with a jump, a wedge alone, steps both ways, a closed form") {
  for (const char* name : {"five_pieces", "wide_parabola"}) {
    check_compiles({"exponents", "-", "--derivation"}, problem_text(name), "enumerate");
  }
}

TEST_CASE("the tables of exponents compile, and fit on their pages") {
  const TemporaryFolder folder;
  REQUIRE(run_other({STEADYSLIDE_EXPONENT_TABLES, "-o", "."}, folder.path()).code == 0);
  std::filesystem::rename(folder.path() / "exponents.tex", folder.path() / "t.tex");
  compile(folder, true);
}
