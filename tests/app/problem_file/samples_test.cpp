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
  // x^2/2 in mm over [-1, 1] mm: once plain, once in um, towards the body, with a slope and an offset added.
  std::string plain, measured;
  for (int k = -200; k <= 200; ++k) {
    const Rational x(k, 200);
    plain += to_string(x) + "," + to_string(x * x / 2) + "\n";
    measured += to_string(x) + "," + to_string(-1000 * (x * x / 2 + 3 * x / 10 + 7)) + "\n";
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
  // 7 and half the mean of x^2, (200 * 201 * 401) / (3 * 401 * 200^2).
  CHECK(number(indenter["detrend"]["height"]) == 7 + Rational(200 * 201, 2 * 3 * 200 * 200));
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

TEST_CASE("a filter and a spline are named in the answer, and leave no wedge") {
  std::string points;
  for (int k = -40; k <= 40; ++k) {
    const Rational x(k, 40);
    points += to_string(x) + "," + to_string(400 * x * x + (k % 2 == 0 ? 1 : -1)) + "\n";
  }
  const TemporaryFolder folder{{"rough.csv", points}};
  const auto samples = [](const std::string& more) {
    return problem("samples = {file = \"rough.csv\", x_unit = \"mm\", height_unit = \"um\"" + more + "}", "0.01");
  };
  const std::string filter = ", filter = {kind = \"gauss\", cutoff = \"0.2\"}", spline = ", interpolate = \"spline\"";
  const auto wedges = [&](const std::string& more) {
    return times(out_of(folder.run({"exponents", "-"}, samples(more))), "wedge");
  };
  CHECK(wedges("") == 79);
  CHECK(wedges(filter) > 70);
  CHECK(wedges(spline) == 0);
  CHECK(wedges(filter + spline) == 0);
  const auto solved = [&](const std::string& more) {
    return json_of(folder.run({"solve", "-", "--format", "json"}, samples(more)));
  };
  const Json smooth = solved(filter + spline);
  const Json& indenter = smooth["problem"]["indenter"];
  CHECK(keys(indenter) == "support samples points x_unit height_unit filter interpolate");
  CHECK(indenter["filter"] == Json{{"kind", "gauss"}, {"cutoff", "0.2"}});
  CHECK(indenter["interpolate"] == "spline");
  CHECK(smooth["method"] == "riemann-hilbert");
  // The filter takes the roughness off: one zone is left. The control: without it there are many.
  CHECK(smooth["contact"].size() == 1);
  CHECK(solved(spline)["contact"].size() > 1);
}

TEST_CASE("friction from a table is friction from values and jumps; a measured profile gives the unit") {
  const TemporaryFolder folder{
      {"f.csv", "x,f\n-5,0.2\n0,0.5\n"}, {"f_um.csv", "-1000,0.2\n0,0.5\n"}, {"trace.csv", "-1,1/4\n0,0\n1,1/4\n"}};
  const auto with = [](const std::string& friction, const std::string& samples) {
    return "load = 0.05\n[half_space]\npoisson = 0.3\n[friction]\n" + friction + "\n[indenter]\nsamples = " + samples +
           "\n";
  };
  const auto answer = [&](const std::string& friction, const std::string& samples) {
    return json_of(folder.run({"solve", "-", "--format", "json"}, with(friction, samples)));
  };
  const std::string plain = "\"trace.csv\"", in_mm = "{file = \"trace.csv\", x_unit = \"mm\"}";
  const Json expected = answer("values = [0.2, 0.5]\njumps = [0]", plain);
  for (const auto& [friction, samples] : {std::pair<std::string, std::string>{"samples = \"f.csv\"", plain},
                                          {"samples = {file = \"f.csv\"}", in_mm},
                                          {"samples = {file = \"f.csv\", x_unit = \"mm\"}", in_mm},
                                          {"samples = {file = \"f_um.csv\", x_unit = \"um\"}", in_mm}}) {
    const Json found = answer(friction, samples);
    CHECK(found["resultants"] == expected["resultants"]);
    CHECK(found["problem"]["friction"]["values"] == Json{"0.2", "0.5"});
    CHECK(found["problem"]["friction"]["jumps"] == Json{"0"});
    CHECK(holds(friction, found["problem"]["friction"]["samples"].get<std::string>()));
  }
  CHECK(keys(expected["problem"]["friction"]) == "values jumps");
}

TEST_CASE("a bad friction table is named with its line") {
  const TemporaryFolder folder{{"f.csv", "x,f\n-0.5,0.2\n0,0.5\n"}};
  const std::string flat =
      "load = 1\n[half_space]\npoisson = 0.3\n[friction]\nsamples = \"f.csv\"\n[indenter]\nprofile = 0\n";
  check_refused(folder.run({"solve", "-"}, flat),
                "f.csv:2: x: friction begins inside the support; the first x is at most the left end, -1; -0.5");
}

TEST_CASE("a small spline is proved, and -v says which method was taken") {
  std::string points;
  for (int k = -5; k < 5; ++k) {
    const Rational x(2 * k + 1, 9);
    points += to_string(x) + "," + to_string((x * x + x * x * x / 7) / 4) + "\n";
  }
  const TemporaryFolder folder{{"ten.csv", points}};
  const Finished proved = folder.run({"solve", "-", "--certify", "-v"},
                                     problem("samples = {file = \"ten.csv\", interpolate = \"spline\"}", "0.01"));
  CHECK(proved.code == 0);
  check_holds(proved.out, {"proved"});
  check_holds(proved.err, {"-: method riemann-hilbert: a formula if one applies; no rule asks for cells\n"});
  CHECK(folder.run({"solve", "-"}, problem("samples = \"ten.csv\"", "0.01")).err == "");
}
