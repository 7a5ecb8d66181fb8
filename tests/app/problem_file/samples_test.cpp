// `samples` of a problem file: the path of the trace, its use, and the errors of both files.

#include "app/json_answers.hpp"

namespace {

std::string problem(const std::string& indenter, const std::string& load = "1") {
  return "load = " + load +
         "\n[half_space]\npoisson = 0.3\n[friction]\nvalues = [0.2, 0.5]\njumps = [0]\n[indenter]\n" + indenter + "\n";
}

const std::string named = R"(samples = "trace.csv")", wedge = "-1,1/4\n0,0\n1,1/2\n";

}  // namespace

TEST_CASE("a trace is looked for beside the problem file; from the standard input, in the working directory") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "data");
  folder.write("data/trace.csv", wedge);
  folder.write("data/s.toml", problem(named));
  const auto code = [](const std::string& file, const std::filesystem::path& where, const std::string& input = "") {
    return run_program({"exponents", file}, where, input).code;
  };
  CHECK(code("data/s.toml", folder.path()) == 0);
  CHECK(code("s.toml", folder.path() / "data") == 0);
  CHECK(code("-", folder.path() / "data", problem(named)) == 0);
  CHECK(code("-", folder.path(), problem(named)) == 2);
  CHECK(code("-", folder.path(), problem(R"(samples = "data/trace.csv")")) == 0);
  const std::string absolute = (folder.path() / "data" / "trace.csv").string();
  folder.write("s.toml", problem("samples = \"" + absolute + "\""));
  CHECK(code("s.toml", folder.path()) == 0);

  folder.write("data/trace.csv", "0,0\n1,one\n");
  check_refused(folder.run({"exponents", "data/s.toml"}),
                "data/trace.csv:2: psi: not a number; a number is written like 2, -0.25, 1e-3 or 1/3; 'one'");
}

TEST_CASE("jumps lie within the trace") {
  const TemporaryFolder folder{{"trace.csv", "1,0\n2,0\n"}};
  check_refused(folder.run({"exponents", "-"}, problem(named)),
                "-:6: friction.jumps[0]: jump outside the support; jumps lie in ]1, 2[; 0");
}

TEST_CASE("a flat trace with any number of points is a flat punch") {
  std::string flat;
  for (int k = -50; k <= 50; ++k) flat += std::to_string(k) + "e-2,0\n";
  const TemporaryFolder folder{{"trace.csv", flat}};
  const Finished samples = folder.run({"solve", "-", "--method", "closed-form"}, problem(named));
  CHECK(samples.code == 0);
  CHECK(samples.out == run(problem("support = [-0.5, 0.5]\nprofile = 0")).out);
}

TEST_CASE("the Riemann-Hilbert method takes at most 200 breaks with more than 16 digits") {
  const TemporaryFolder folder;
  const auto solve = [&](int points, const char* digits) {
    std::string text;
    for (int k = 0; k < points; ++k) text += std::to_string(k - 10) + "," + std::to_string(k * k) + "e-6\n";
    folder.write("trace.csv", text);
    return folder.run({"solve", "-", "--method", "riemann-hilbert", "--digits", digits}, problem(named));
  };
  check_refused(solve(203, "17"),
                "-: the profile has too many breaks for the Riemann-Hilbert method with more than 16 digits; it has at "
                "most 200; 201 breaks");
  CHECK(solve(203, "16").code == 0);
}

TEST_CASE("a trace with units, changed sign and subtracted trend is the measured profile") {
  // x^2 in mm over [-1, 1] mm: once plain, once in um, towards the body, with a slope and an offset added.
  std::string plain, measured;
  for (int k = -200; k <= 200; ++k) {
    const Rational x(k, 200);
    plain += to_string(x) + "," + to_string(x * x) + "\n";
    measured += to_string(x) + "," + to_string(-1000 * (x * x + 3 * x / 10 + 7)) + "\n";
  }
  const TemporaryFolder folder{{"plain.csv", plain}, {"measured.csv", measured}};
  const auto run_on_cells = [&](const std::string& indenter) {
    return folder.run(
        {"solve", "-", "--method", "variational", "--cells", "1024", "--at=-0.1:0.1:0.05", "--format", "json"},
        problem(indenter, "0.01"));
  };
  const auto solved = [&](const std::string& indenter) { return json_of(run_on_cells(indenter)); };
  const Json expected = solved("samples = \"plain.csv\"");
  const Json found = solved(
      "samples = {file = \"measured.csv\", x_unit = \"mm\", height_unit = \"um\", flip = true, detrend = \"line\"}");
  const auto ends = [](const Json& solution) {
    const Json& zone = solution["contact"][0];
    return std::pair(zone["left"]["x"], zone["right"]["x"]);
  };
  CHECK(ends(found) == ends(expected));
  CHECK(near(found["resultants"]["effective_friction"], expected["resultants"]["effective_friction"], "1e-12"));
  const Json& indenter = found["problem"]["indenter"];
  CHECK(indenter["samples"] == "measured.csv");
  CHECK(indenter["points"] == 401);
  CHECK(indenter["x_unit"] == "mm");
  CHECK(indenter["height_unit"] == "um");
  CHECK(indenter["flip"] == true);
  CHECK(keys(indenter["detrend"]) == "taken_off height slope");
  CHECK(indenter["detrend"]["taken_off"] == "line");
  CHECK(number(indenter["detrend"]["slope"]) == Rational(3, 10));
  // 7 and the mean of x^2, (200 * 201 * 401) / (3 * 401 * 200^2).
  CHECK(number(indenter["detrend"]["height"]) == 7 + Rational(200 * 201, 3 * 200 * 200));
  CHECK(keys(expected["problem"]["indenter"]) == "support samples points");

  // The labels of lengths in the picture.
  CHECK(folder
            .run({"solve", "-", "--method", "variational", "--cells", "256", "--plot", "p.svg"},
                 problem("samples = {file = \"plain.csv\", x_unit = \"um\"}", "0.01"))
            .code == 0);
  check_holds(folder.read("p.svg"), {"(µm)", "user's unit of stress"});

  // Controls: without the sign, contact is at both ends of the trace; without the unit, in less than a cell.
  const Finished unturned =
      run_on_cells("samples = {file = \"measured.csv\", x_unit = \"mm\", height_unit = \"um\", detrend = \"line\"}");
  CHECK(unturned.code == 1);
  check_holds(unturned.err, {"all contact lies within the last 1 % of the trace"});
  const Finished steep = run_on_cells("samples = {file = \"measured.csv\", flip = true, detrend = \"line\"}");
  CHECK(steep.code == 1);
  check_holds(steep.err, {"ends of contact: large estimated error"});
}
