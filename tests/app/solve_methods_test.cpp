// Which method solves, what it refuses, how a solve ends that does not converge, and tilt.

#include "app/json_answers.hpp"

namespace {

const std::string parabola = problem_text("coated_parabola");
const std::string punch = problem_text("coated_punch"), quartic = problem_text("quartic");

}  // namespace

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

TEST_CASE("what does not converge is written all the same") {
  const TemporaryFolder folder;
  const Finished json =
      run_program({"solve", "-", "--format", "json", "-o", "result"}, folder.path(), problem_text("tiny_step"));
  CHECK(json.code == 1);
  CHECK(json.out == "");
  CHECK(Json::parse(folder.read("result"))["contact"].size() >= 1);
}

TEST_CASE("tilt: only with load_at, and the pressure's centre lies under the load") {
  for (const char* at : {"-0.4", "0", "0.3", "0.85"}) {
    CAPTURE(at);
    const std::string tilting = "load_at = \"" + std::string(at) + "\"\n" + punch;
    const Json json = solve(tilting);
    CHECK(near(json["resultants"]["centre_of_pressure"], at, "1e-12"));
    CHECK(holds(run(tilting).out, "  tilt "));
    CHECK(json["uniqueness"]["status"] == "not_covered");
    // The same with the slope put into the profile of an indenter that keeps its attitude.
    const std::string tilt = json["resultants"]["tilt"].get<std::string>();
    const Json fixed = solve(replaced(punch, "profile = \"0\"", "profile = \"" + tilt + "*x\""));
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
