// Bad command lines: the whole message and the exit code of each; help. bad_command_lines.json has the text of the
// message after "steadyslide: command line: ". {a,b} stands for two lines, one with a and one with b; {} is the chosen
// one.

#include "app/command_line.hpp"
#include "support/rows.hpp"

TEST_CASE("bad command lines: message, exit code, no output") {
  const TemporaryFolder folder;
  const std::string rest = "load = 1\n[half_space]\npoisson = 0.3\n[friction]\nvalues = [0.2]\n[indenter]\n";
  folder.write("good.toml", rest + "profile = 0\n");
  folder.write("wedge.toml", rest + "pieces = [{to = 0, profile = \"-x\"}, {to = 1, profile = \"x\"}]\n");
  folder.write("tilt.toml", "load_at = 0\n" + rest + "profile = 0\n");
  folder.write("reduced.toml", replaced(rest, "poisson = 0.3", "gamma = 0.25") + "profile = 0\n");
  folder.write("surface.csv", "0,0\n");
  std::string trace;  // a trace with more breaks than the Riemann-Hilbert method takes
  for (int k = -101; k <= 101; ++k) trace += std::to_string(k) + "e-2," + std::to_string(k * k) + "e-4\n";
  folder.write("rough.csv", trace);
  folder.write("rough.toml", rest + "samples = \"rough.csv\"\n");
  const auto refused = [&](const Arguments& arguments, const std::string& message) {
    CAPTURE(message);
    check_refused(folder.run(arguments), "command line: " + message);
  };
  const auto bad_lines = rows_of(STEADYSLIDE_TESTS "/app/commands/bad_command_lines.json");
  CHECK(bad_lines.size() >= 70);
  for (const auto& [line, message] : bad_lines) {
    for (const auto& [command, name] : choices(line)) refused(arguments_of(command), filled(message, name));
  }
  refused({"solve", "good.toml", "two\nlines"}, "one argument too many; solve --help lists them; 'two\\x0alines'");
  CHECK(folder.names() == std::vector<std::string>{"good.toml", "reduced.toml", "rough.csv", "rough.toml",
                                                   "surface.csv", "tilt.toml", "wedge.toml"});
}

TEST_CASE("--help prints complete help at every level to the standard output") {
  check_holds(out_of(run_alone({"--help"})), {"verify", "exponents", "table", "solve", "design", "sweep", "figures",
                                              "report", "Units", "Signs", "Exit code"});
  for (const std::string command : {"verify", "exponents", "table", "solve", "design", "sweep", "figures", "report"}) {
    CHECK(holds(out_of(run_alone({command, "--help"})), "steadyslide " + command));
  }
  CHECK(holds(run_alone({"exponents", "--help"}).out, "away from the body"));
  CHECK(run_alone({"--version"}).out == "steadyslide " STEADYSLIDE_VERSION "\n");
}
