// A LaTeX table compiles. Needs pdflatex; where it is absent the test says so and checks the text only.

#include "app/command_line.hpp"

using namespace steadyslide::testing;

namespace {

/// t.tex of the folder.
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

void check_compiles(const Arguments& arguments, const std::string& input = "",
                    const std::string& last_environment = "longtable") {
  const TemporaryFolder folder;
  REQUIRE(run_program(joined(arguments, {"--format", "latex", "-o", "t.tex"}), folder.path(), input).code == 0);
  const std::string text = folder.read("t.tex");
  CHECK(text.starts_with("\\documentclass{article}\n"));
  CHECK(text.ends_with("\\end{" + last_environment + "}\n\\end{document}\n"));
  compile(folder, last_environment == "longtable");
}

}  // namespace

TEST_CASE("tables compile, narrow and wide") {
  check_compiles({"table", "--poisson=-0.5:0.45:0.05", "--rear", "0:2:0.5", "--front", "0,1e-30,1.5"});
  check_compiles({"table", "--poisson", "0.3", "--rear", "0.1", "--front", "0.2", "--digits", "100"});
  check_compiles({"table", "--poisson", "0", "--rear", "0", "--front", "0", "--digits", "1"});
}

TEST_CASE("exponents compile") {
  check_compiles(
      {"exponents", "-", "--digits", "50"},
      "load = 1\n[half_space]\ngamma = \"1/2\"\n[friction]\nvalues = [2, 0.123456789, 0]\njumps = [0, 0.5]\n"
      "[indenter]\npieces = [{to = 0, profile = \"-x\"}, {to = \"1/3\", profile = \"x\"}, {to = 0.9, profile "
      "= \"2*x\"}, {to = 1, profile = \"x+0.9\"}]\n");
}

TEST_CASE("derivations compile: jumps, a wedge with a jump, a wedge alone, steps both ways, a closed form") {
  check_compiles(
      {"exponents", "-", "--derivation"},
      "load = 1\n[half_space]\npoisson = 0.3\n[friction]\nvalues = [0.2, 0.6, 0.1]\njumps = [-0.5, 0.5]\n"
      "[indenter]\npieces = [{to = -0.5, profile = \"-x\"}, {to = 0, profile = \"x+1\"}, {to = 0.25, profile "
      "= \"2*x+1\"}, {to = 0.75, profile = \"x\"}, {to = 1, profile = \"x+1\"}]\n",
      "enumerate");
  check_compiles({"exponents", "-", "--derivation"},
                 "load = 1\n[half_space]\ngamma = \"1/2\"\n[friction]\nvalues = [2, 0]\njumps = [0]\n"
                 "[indenter]\nsupport = [-9, 9]\nprofile = \"x^2\"\n",
                 "enumerate");
}

TEST_CASE("the tables of exponents compile, and fit on their pages") {
  const TemporaryFolder folder;
  std::filesystem::copy_file(STEADYSLIDE_DOCS "/exponents.tex", folder.path() / "t.tex");
  compile(folder, true);
}
