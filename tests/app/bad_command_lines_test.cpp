// Bad command lines: the whole message and the exit code of each.

#include "app/command_line.hpp"

using namespace steadyslide::testing;

namespace {

struct BadLine {
  Arguments arguments;
  std::string message;  ///< after "steadyslide: command line: "
};

Arguments table(const std::string& poisson, const std::string& rear, const std::string& front) {
  return {"table", "--poisson", poisson, "--rear", rear, "--front", front};
}

const std::string number_rule = "a number is written like 2, -0.25, 1e-3 or 1/3";
const std::string digits_rule = "--digits: out of range; it is a whole number from 1 to 100; ";

const std::string double_rule = "--digits: out of range; the variational method works in double, 16 digits at most; ";
const std::string cells_rule =
    "method without cells; it goes with --method variational, with auto where that takes it, and with "
    "--search-solutions; ";
const std::string search_rule =
    "--search-solutions: conflicting option; it compares contact zones and resultants under the file's load; ";

const std::vector<BadLine> bad_lines{
    {{}, "no command; it is one of verify, exponents, table, solve, figures, report; see --help"},
    {{"solv"}, "unknown command; it is one of verify, exponents, table, solve, figures, report; 'solv'"},
    {{"--frobnicate"}, "unknown option; --help lists them; '--frobnicate'"},
    {{"solve", "good.toml", "--digit", "5"}, "unknown option; solve --help lists them; '--digit'"},
    {{"solve"}, "PROBLEM is required"},
    {{"solve", "good.toml", "other.toml"}, "one argument too many; solve --help lists them; 'other.toml'"},
    {{"solve", "good.toml", "two\nlines"}, "one argument too many; solve --help lists them; 'two\\x0alines'"},
    {{"solve", "good.toml", "--digits", "0"}, digits_rule + "'0'"},
    {{"solve", "good.toml", "--digits", "101"}, digits_rule + "'101'"},
    {{"solve", "good.toml", "--digits", "ten"}, digits_rule + "'ten'"},
    {{"solve", "good.toml", "--digits", "16.0"}, digits_rule + "'16.0'"},
    {{"solve", "good.toml", "--digits="}, "--digits: 1 required N missing"},
    {{"exponents", "good.toml", "--digits", "-5"}, digits_rule + "'-5'"},
    {{"verify", "--digits", "1000"}, digits_rule + "'1000'"},
    {{"solve", "good.toml", "--format", "xml"}, "--format: unknown format; it is one of text, json, csv; 'xml'"},
    {{"solve", "good.toml", "--format", "latex"}, "--format: unknown format; it is one of text, json, csv; 'latex'"},
    {{"exponents", "good.toml", "--format", "JSON"},
     "--format: unknown format; it is one of text, json, csv, markdown, latex; 'JSON'"},
    {{"verify", "--format", "csv"}, "--format: unknown format; it is one of text, json, markdown; 'csv'"},
    {{"solve", "good.toml", "--method", "guess"},
     "--method: unknown method; it is one of auto, closed-form, riemann-hilbert, variational; 'guess'"},
    {{"solve", "good.toml", "--cells", "100"}, "--cells: " + cells_rule + "'--method auto'"},
    {{"solve", "good.toml", "--iterations", "9"}, "--iterations: " + cells_rule + "'--method auto'"},
    {{"solve", "good.toml", "--method", "closed-form", "--cells", "100"},
     "--cells: " + cells_rule + "'--method closed-form'"},
    {{"solve", "good.toml", "--method", "riemann-hilbert", "--iterations", "9"},
     "--iterations: " + cells_rule + "'--method riemann-hilbert'"},
    {{"solve", "good.toml", "--method", "variational", "--cells", "15"},
     "--cells: out of range; it is a whole number from 16 to 4194304; '15'"},
    {{"solve", "good.toml", "--method", "variational", "--cells", "4194305"},
     "--cells: out of range; it is a whole number from 16 to 4194304; '4194305'"},
    {{"solve", "good.toml", "--method", "variational", "--iterations", "0"},
     "--iterations: out of range; it is a whole number from 1 to 10000; '0'"},
    {{"solve", "good.toml", "--method", "variational", "--digits", "17"}, double_rule + "'17'"},
    {{"solve", "rough.toml", "--digits", "50"}, double_rule + "'50'"},
    {{"solve", "good.toml", "--search-solutions", "3", "--digits", "17"}, double_rule + "'17'"},
    {{"solve", "good.toml", "--load-steps="}, "--load-steps: 1 required LIST missing"},
    {{"solve", "good.toml", "--load-steps", ""}, "--load-steps: no value; it is a list; ''"},
    {{"solve", "good.toml", "--load-steps", "1,0,2"}, "--load-steps: load out of range; the load is positive; '0'"},
    {{"solve", "good.toml", "--load-steps=-1/3"}, "--load-steps: load out of range; the load is positive; '-1/3'"},
    {{"solve", "good.toml", "--load-steps", "0:1:0.1"}, "--load-steps: load out of range; the load is positive; '0'"},
    {{"solve", "good.toml", "--load-steps", "1,heavy"}, "--load-steps: not a number; " + number_rule + "; 'heavy'"},
    {{"solve", "good.toml", "--load-steps", "1:10001:1"},
     "--load-steps: list too long; there are at most 10000 entries; '1:10001:1'"},
    {{"solve", "good.toml", "--load-steps", "1,2", "--at", "0"},
     "--load-steps: conflicting option; samples are those of one load; '--at'"},
    {{"solve", "good.toml", "--load-steps", "1,2", "--samples", "5"},
     "--load-steps: conflicting option; samples are those of one load; '--samples'"},
    {{"solve", "good.toml", "--load-steps", "1,2", "--cells", "50"}, "--cells: " + cells_rule + "'--method auto'"},
    {{"solve", "good.toml", "--load-steps", "1,2", "--format", "latex"},
     "--format: unknown format; it is one of text, json, csv; 'latex'"},
    {{"solve", "good.toml", "--search-solutions", "0"},
     "--search-solutions: out of range; it is a whole number from 1 to 1000; '0'"},
    {{"solve", "good.toml", "--search-solutions", "1001"},
     "--search-solutions: out of range; it is a whole number from 1 to 1000; '1001'"},
    {{"solve", "good.toml", "--search-solutions", "3", "--at", "0"}, search_rule + "'--at'"},
    {{"solve", "good.toml", "--search-solutions", "3", "--samples", "5"}, search_rule + "'--samples'"},
    {{"solve", "good.toml", "--search-solutions", "3", "--load-steps", "1,2"}, search_rule + "'--load-steps'"},
    {{"solve", "good.toml", "--search-solutions", "3", "--method", "riemann-hilbert"},
     "--search-solutions: conflicting option; it searches by the variational method; '--method riemann-hilbert'"},
    {{"exponents", "good.toml", "--derivation", "--format", "csv"},
     "--derivation: wrong format; a derivation is text or latex; 'csv'"},
    {{"solve", "good.toml", "--at", "0,,1"}, "--at: not a number; " + number_rule + "; ''"},
    {{"solve", "good.toml", "--at", "here"}, "--at: not a number; " + number_rule + "; 'here'"},
    {{"solve", "good.toml", "--at="}, "--at: 1 required LIST missing"},
    {{"solve", "good.toml", "--samples", "0"}, "--samples: out of range; it is a whole number from 1 to 100000; '0'"},
    {{"solve", "good.toml", "--samples", "1e3"},
     "--samples: out of range; it is a whole number from 1 to 100000; '1e3'"},
    {{"solve", "good.toml", "-o", ""}, "--output: no file; it has a name; ''"},
    {{"solve", "wedge.toml", "--method", "closed-form"},
     "--method closed-form: no closed form applies; the profile is neither flat nor a parabola that opens away from "
     "the body"},
    {{"solve", "wedge.toml", "--method", "closed-form", "--load-steps", "1,2"},
     "--method closed-form: no closed form applies; the profile is neither flat nor a parabola that opens away from "
     "the body"},
    {{"solve", "tilt.toml", "--method", "closed-form"},
     "--method closed-form: no closed form applies; the indenter may tilt"},
    {{"table", "--poisson", "0", "--rear", "0"}, "--front is required"},
    {table("0.5", "0", "0"), "--poisson: Poisson's ratio out of range; it lies in ]-1, 1/2[; 0.5"},
    {table("0:0.4:0", "0", "0"), "--poisson: step out of range; the step is positive; '0'"},
    {table("0.4:0:-0.1", "0", "0"), "--poisson: step out of range; the step is positive; '-0.1'"},
    {table("0.4:0:0.1", "0", "0"), "--poisson: empty range; FIRST is at most LAST; '0.4:0:0.1'"},
    {table("0:0.4", "0", "0"), "--poisson: not a range; a range is written FIRST:LAST:STEP; '0:0.4'"},
    {table("0", "-0.1", "0"), "--rear: negative friction coefficient; a friction coefficient is at least 0; '-0.1'"},
    {table("0", "0", "0,x"), "--front: not a number; " + number_rule + "; 'x'"},
    {table("0", "0:1:1e-300", "0"), "--rear: list too long; there are at most 1000000 entries; '0:1:1e-300'"},
    {table("0:0.4:0.1", "0:1:0.001", "0:1:0.001"), "table too long; there are at most 1000000 rows; 5 x 1001 x 1001"},
    {{"verify", "--seed", "-1"}, "--seed: out of range; it is a whole number from 0 to 2^64-1; '-1'"},
};

}  // namespace

TEST_CASE("bad command lines: message, exit code, no output") {
  const TemporaryFolder folder;
  const std::string rest = "load = 1\n[half_space]\npoisson = 0.3\n[friction]\nvalues = [0.2]\n[indenter]\n";
  folder.write("good.toml", rest + "profile = 0\n");
  folder.write("wedge.toml", rest + "pieces = [{to = 0, profile = \"-x\"}, {to = 1, profile = \"x\"}]\n");
  folder.write("tilt.toml", "load_at = 0\n" + rest + "profile = 0\n");
  std::string trace;  // of more breaks than the Riemann-Hilbert method takes
  for (int k = -101; k <= 101; ++k) trace += std::to_string(k) + "e-2," + std::to_string(k * k) + "e-4\n";
  folder.write("rough.csv", trace);
  folder.write("rough.toml", rest + "samples = \"rough.csv\"\n");
  for (const BadLine& bad : bad_lines) {
    CAPTURE(bad.message);
    check_refused(run_program(bad.arguments, folder.path()), "command line: " + bad.message);
  }
  CHECK(folder.names() == std::vector<std::string>{"good.toml", "rough.csv", "rough.toml", "tilt.toml", "wedge.toml"});
}

TEST_CASE("help is complete at every level, and a result") {
  check_holds(out_of(run_alone({"--help"})),
              {"verify", "exponents", "table", "solve", "figures", "report", "Units", "Signs", "Exit code"});
  for (const std::string command : {"verify", "exponents", "table", "solve", "figures", "report"}) {
    CHECK(holds(out_of(run_alone({command, "--help"})), "steadyslide " + command));
  }
  CHECK(holds(run_alone({"solve", "--help"}).out, "away from the body"));
  CHECK(run_alone({"--version"}).out == "steadyslide " STEADYSLIDE_VERSION "\n");
}
