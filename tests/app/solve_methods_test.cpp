// Which method solves, what it refuses, how a solve ends that does not converge, and tilt.

#include "app/json_answers.hpp"

namespace {

const std::string body =
    "[half_space]\npoisson = 0.3\n[friction]\nvalues = [0.2, 0.6]\njumps = [\"0.1\"]\n[indenter]\n";
const std::string one_friction = "[half_space]\npoisson = 0.3\n[friction]\nvalues = [0.4]\n[indenter]\n";
const std::string parabola = "load = \"0.1\"\n" + body + "profile = \"x^2\"\n";
const std::string large_parabola = "load = 10\n" + body + "profile = \"x^2\"\n";
const std::string punch = "load = 2\n" + body + "profile = 0\n";
const std::string quartic = "load = 1\n" + body + "profile = \"x^4\"\n";
const std::string elastic = "elastic = {poisson = 0.3, young = 2}\n";
/// The upper face touches at a distance from the step that no number here can hold: stays unsolved.
const std::string unsolved =
    "load = 1\n" + one_friction + "pieces = [{to = 0, profile = 0}, {to = 1, profile = \"1e-300\"}]\n";

}  // namespace

TEST_CASE("auto takes the closed form where there is one, else the Riemann-Hilbert method") {
  CHECK(solve(parabola)["method"] == "closed-form");
  CHECK(solve(punch)["method"] == "closed-form");
  CHECK(solve(large_parabola)["method"] == "riemann-hilbert");
  CHECK(solve(quartic)["method"] == "riemann-hilbert");
  CHECK(solve("load_at = 0\n" + punch)["method"] == "riemann-hilbert");
  CHECK(solve(parabola, {"--method", "riemann-hilbert"})["method"] == "riemann-hilbert");
}

TEST_CASE("both methods say the same, at 16 and at 50 digits") {
  for (const std::string& problem : {parabola, punch}) {
    for (const auto& [digits, tolerance] : {std::pair("16", "1e-12"), {"50", "1e-46"}}) {
      const Arguments arguments{"--digits", digits, "--at=-0.05,0,0.1,0.9"};
      const Json formula = solve(problem, arguments);
      const Json solved = solve(problem, joined(arguments, {"--method", "riemann-hilbert"}));
      CHECK(formula["problem"] == solved["problem"]);
      for (const char* end : {"left", "right"}) {
        CHECK(near(formula["contact"][0][end]["x"], solved["contact"][0][end]["x"], tolerance));
        CHECK(near(formula["contact"][0][end]["intensity"], solved["contact"][0][end]["intensity"], tolerance));
      }
      for (const char* key : {"normal", "tangential", "centre_of_pressure", "effective_friction"}) {
        CHECK(near(formula["resultants"][key], solved["resultants"][key], tolerance));
      }
      for (const std::size_t k : {0, 1, 3}) {
        CHECK(near(formula["samples"][k]["traction"], solved["samples"][k]["traction"], tolerance));
        CHECK(near(formula["samples"][k]["gap"], solved["samples"][k]["gap"], tolerance));
      }
      CHECK(solved["samples"][2]["traction"] == "-inf");
    }
  }
}

TEST_CASE("50 digits continue 16") {
  const Json sixteen = solve(quartic, {"--at", "0.3"});
  const Json fifty = solve(quartic, {"--at", "0.3", "--digits", "50"});
  CHECK(fifty["digits"] == 50);
  CHECK(fifty["contact"][0]["left"]["x"].get<std::string>().size() >= 50);
  CHECK(near(sixteen["contact"][0]["left"]["x"], fifty["contact"][0]["left"]["x"], "1e-13"));
  CHECK(near(sixteen["samples"][0]["traction"], fifty["samples"][0]["traction"], "1e-13"));
  CHECK(number(fifty["residuals"]["equation"]) < 1e-45_r);
}

TEST_CASE("an elastic indenter whose contact reaches an edge has no solution on a half-plane") {
  CHECK(solve(quartic + elastic)["contact"][0]["left"]["kind"] == "free");
  check_refused(run(replaced(quartic, "load = 1", "load = 100") + elastic),
                "-: the contact of an elastic indenter reaches an edge, where the half-plane idealisation fails");
}

TEST_CASE("what does not converge is printed, one line says why, and the exit code is 1") {
  const Finished text = run(unsolved);
  CHECK(text.code == 1);
  CHECK(holds(text.err, "steadyslide: -: the solve did not converge: "));
  CHECK(text.err.ends_with("; what was reached is printed\n"));
  CHECK(holds(text.out, "\ncontact\n  from x = -1 (edge) to x = 0 (step)\n"));
  const TemporaryFolder folder;
  const Finished json = run_program({"solve", "-", "--format", "json", "-o", "result"}, folder.path(), unsolved);
  CHECK(json.code == 1);
  CHECK(json.out == "");
  CHECK(Json::parse(folder.read("result"))["contact"].size() >= 1);
}

TEST_CASE("tilt: only with load_at, and the pressure's centre lies under the load") {
  CHECK_FALSE(solve(quartic)["resultants"].contains("tilt"));
  CHECK_FALSE(holds(run(quartic).out, "tilt"));
  for (const char* at : {"-0.4", "0", "0.3", "0.85"}) {
    CAPTURE(at);
    const std::string tilting = "load_at = \"" + std::string(at) + "\"\n" + punch;
    const Json json = solve(tilting);
    CHECK(near(json["resultants"]["centre_of_pressure"], at, "1e-12"));
    CHECK(holds(run(tilting).out, "  tilt "));
    CHECK(json["uniqueness"]["status"] == "not_covered");
    // The same with the slope put into the profile of an indenter that keeps its attitude.
    const std::string tilt = json["resultants"]["tilt"].get<std::string>();
    const Json fixed = solve(replaced(punch, "profile = 0", "profile = \"" + tilt + "*x\""));
    CHECK(near(fixed["resultants"]["centre_of_pressure"], at, "1e-11"));
    CHECK(near(fixed["resultants"]["effective_friction"], json["resultants"]["effective_friction"], "1e-11"));
  }
}

TEST_CASE("data that double cannot hold are solved with 50 digits") {
  const Json usual = solve(quartic);
  const Json soft = solve(replaced(replaced(quartic, "load = 1", "load = \"1e-200\""), "poisson = 0.3",
                                   "poisson = 0.3\nyoung = \"1e-200\""));
  CHECK(near(soft["contact"][0]["left"]["x"], usual["contact"][0]["left"]["x"], "1e-13"));
  CHECK(near(soft["resultants"]["effective_friction"], usual["resultants"]["effective_friction"], "1e-13"));
  CHECK(near(soft["resultants"]["normal"], "1e-200", "1e-213"));
  // Not the digits of double: they could not be this small.
  CHECK(number(soft["residuals"]["equation"]) < 1e-40_r);
}
