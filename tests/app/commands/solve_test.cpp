#include "app/json_answers.hpp"

namespace {

const std::string punch = problem_text("punch"), parabola = problem_text("parabola");
const std::string coated_parabola = problem_text("coated_parabola");
const std::string coated_punch = problem_text("coated_punch"), quartic = problem_text("quartic");

/// Is each number's error beside it, and at least a tenth (it is an estimate) of what differs from the reference? How
/// many are there?
int check_errors(const Json& object, const Json& reference) {
  int count = 0;
  if (object.is_array()) {
    for (std::size_t k = 0; k < object.size(); ++k) count += check_errors(object[k], reference[k]);
    return count;
  }
  if (!object.is_object()) return count;
  for (const auto& item : object.items()) {
    const Json& value = item.value();
    count += check_errors(value, reference[item.key()]);
    if (!value.is_string() || !object.contains(item.key() + "_error")) continue;
    CAPTURE(item.key() + " = " + value.dump());
    const Rational error = number(object[item.key() + "_error"]);
    const Rational rounding = 1e-16_r * (1 + abs(number(value)));
    CHECK(abs(number(value) - number(reference[item.key()])) <= 10 * error + rounding);
    CHECK(error >= 0);
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("more digits continue fewer, and all three types agree") {
  const Json sixteen = solve(parabola, {"--at", "0.1"});
  const Json fifty = solve(parabola, {"--at", "0.1", "--digits", "50"});
  const Json hundred = solve(parabola, {"--at", "0.1", "--digits", "100"});
  const auto traction = [](const Json& json) { return json["samples"][0]["traction"].get<std::string>(); };
  CHECK(near(sixteen["samples"][0]["traction"], traction(fifty).c_str(), "1e-13"));
  CHECK(near(fifty["samples"][0]["traction"], traction(hundred).c_str(), "1e-48"));
  CHECK(traction(fifty).size() >= 50);
  CHECK(traction(hundred).size() >= 100);
}

TEST_CASE("data that double cannot hold are solved all the same") {
  const Json json = solve(replaced(punch, "load = 2", "load = \"2e-300\""), {"--at", "0.5"});
  const Json usual = solve(punch, {"--at", "0.5"});
  CHECK(near(json["resultants"]["normal"], "2e-300", "1e-312"));
  const Rational scaled = number(json["samples"][0]["traction"]) * 1e300_r;
  CHECK(abs(scaled - number(usual["samples"][0]["traction"])) < 1e-13_r);
}

TEST_CASE("CSV: samples, two rows where limits differ, 101 by default") {
  const auto rows = lines(output(punch, {"--at=-2,0,0.5", "--format", "csv"}));
  REQUIRE(rows.size() == 5);
  CHECK(rows[0] == "x,traction,shear,gap,slope,traction_error,shear_error,gap_error,slope_error");
  CHECK(rows[1].starts_with("-2,0,0,,"));
  CHECK(rows[2] == "0,-inf,0,0,0,0,0,0,0");
  CHECK(rows[3] == "0,-inf,inf,0,0,0,0,0,0");
  CHECK(rows[4].starts_with("0.5,"));
  CHECK(lines(output(punch, {"--format", "csv"})).size() == 102);
}

TEST_CASE("every number has its error beside it, of the same shape; it is the error of what is printed") {
  for (const std::string& problem : {punch, parabola}) {
    const Json json = solve(problem, {"--at=-1,0,0.1,2", "--samples", "3"});
    const Json exact = solve(problem, {"--at=-1,0,0.1,2", "--samples", "3", "--digits", "40"});
    int numbers = 0;
    for (const char* part : {"contact", "singular_points", "resultants"})
      numbers += check_errors(json[part], exact[part]);
    CHECK(numbers >= 14);
    CHECK(json["version"] == STEADYSLIDE_VERSION);
    CHECK(json["resultants"]["load_share"].size() == json["resultants"]["load_share_error"].size());
    for (const Json& sample : json["samples"]) {
      for (const std::string key : {"traction", "shear", "gap", "slope"}) {
        CHECK(sample[key].type() == sample[key + "_error"].type());
      }
    }
  }
}

TEST_CASE("16 digits give the doubles back: |shear| is f |traction| to the last bit") {
  const Json json = solve(parabola, {"--samples", "9"});
  for (const Json& sample : json["samples"]) {
    const double traction = std::stod(sample["traction"].get<std::string>());
    const double shear = std::stod(sample["shear"].get<std::string>());
    if (traction == 0) continue;
    const double f = std::stod(sample["x"].get<std::string>()) < 0 ? 0.2 : 1.2;
    CHECK(shear == -f * traction);
  }
}

TEST_CASE("--method closed-form is what auto takes") {
  CHECK(output(parabola, {"--method", "closed-form"}) == output(parabola));
}

TEST_CASE("both methods say the same, at 16 and at 50 digits") {
  for (const std::string& problem : {coated_parabola, coated_punch}) {
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
    const std::string tilting = "load_at = \"" + std::string(at) + "\"\n" + coated_punch;
    const Json json = solve(tilting);
    CHECK(near(json["resultants"]["centre_of_pressure"], at, "1e-12"));
    CHECK(holds(run(tilting).out, "  tilt "));
    CHECK(json["uniqueness"]["status"] == "not_covered");
    // The same with the slope put into the profile of an indenter that keeps its attitude.
    const std::string tilt = json["resultants"]["tilt"].get<std::string>();
    const Json fixed = solve(replaced(coated_punch, "profile = \"0\"", "profile = \"" + tilt + "*x\""));
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
