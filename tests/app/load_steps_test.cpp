// solve --load-steps: one row for each load and contact component.

#include "app/json_answers.hpp"

namespace {

const std::string header =
    "load,component,left,left_kind,left_intensity,right,right_kind,right_intensity,effective_friction,"
    "centre_of_pressure,load_share,tilt,shortcoming";
const std::string errors =
    ",left_error,left_intensity_error,right_error,right_intensity_error,effective_friction_error,"
    "centre_of_pressure_error,load_share_error,tilt_error";
const std::string body = "[half_space]\npoisson = 0.3\n[friction]\nvalues = [0.1, 0.7]\njumps = [0]\n[indenter]\n";
// The load is replaced: nobody solves this one.
const std::string parabola = "load = \"1e300\"\n" + body + "profile = \"x^2\"\n";
const std::string bumps = "load = 1\n" + body + "support = [-2, 2]\nprofile = \"(x^2-1)^2/4\"\n";
const std::string elastic = "load = 1\n" + body + "profile = \"x^4\"\nelastic = {poisson = 0.3, young = 2}\n";

Finished run_steps(const std::string& problem, const std::string& loads, const Arguments& arguments = {}) {
  return run(problem, joined({"--load-steps", loads}, arguments));
}

Json solve_steps(const std::string& problem, const std::string& loads, const Arguments& arguments = {}) {
  return solve(problem, joined({"--load-steps", loads}, arguments));
}

}  // namespace

TEST_CASE("CSV: always the same columns, loads in the list's order") {
  const auto rows = lines(out_of(run_steps(bumps, "0.1,1,0.05", {"--format", "csv"})));
  REQUIRE(rows.size() == 6);
  CHECK(rows[0] == header + errors);
  const std::vector<std::string> starts{"0.1,1,-1.", "0.1,2,0.", "1,1,-1.", "0.05,1,-1.", "0.05,2,0."};
  for (std::size_t k = 0; k < starts.size(); ++k) {
    CHECK(rows[k + 1].starts_with(starts[k]));
    CHECK(times(rows[k + 1], ",") == 20);
    CHECK(holds(rows[k + 1], ",,,"));  // neither tilt nor shortcoming
    CHECK(rows[k + 1].ends_with(","));
  }
}

TEST_CASE("JSON: rows with the same keys, shares as a list, null where there is nothing") {
  const Json json = solve_steps(bumps, "0.1");
  REQUIRE(json.size() == 2);
  CHECK(keys(json[0], ",") == header + ",warnings" + errors);
  CHECK(json[1]["component"] == "2");
  CHECK(json[0]["tilt"].is_null());
  CHECK(json[0]["shortcoming"].is_null());
  CHECK(json[0]["warnings"] == Json::array());
  CHECK(json[0]["tilt_error"].is_null());
  CHECK(number(json[0]["left_error"]) < 1e-12_r);
  CHECK(json[0]["load_share_error"].size() == 2);
  CHECK(abs(number(json[0]["load_share"][0]) + number(json[0]["load_share"][1]) - 1) < 1e-12_r);
}

TEST_CASE("text: a table with a dash where there is nothing") {
  const auto rows = lines(run_steps(bumps, "0.1,1").out);
  REQUIRE(rows.size() == 4);
  CHECK(rows[0].starts_with("load  component  left "));
  CHECK(holds(rows[3], " -     -"));
}

TEST_CASE("under a parabola the ends move outwards with the load, also where it reaches the edges") {
  const Json json = solve_steps(parabola, "0.1:3:0.1");
  REQUIRE(json.size() == 30);
  for (std::size_t k = 1; k < json.size(); ++k) {
    const bool at_left_edge = json[k]["left_kind"] == "edge";
    const bool at_right_edge = json[k]["right_kind"] == "edge";
    CHECK((number(json[k]["left"]) < number(json[k - 1]["left"]) || at_left_edge));
    CHECK((number(json[k]["right"]) > number(json[k - 1]["right"]) || at_right_edge));
  }
  CHECK(json[0]["left_kind"] == "free");
  CHECK(json[29]["left_kind"] == "edge");
}

TEST_CASE("each row is what a single solve says, whatever came before") {
  for (const auto& [digits, loads] : {std::pair("16", "1,0.3,0.77,0.9"), {"30", "1,0.3"}}) {
    const Json steps = solve_steps(bumps, loads, {"--digits", digits});
    std::map<std::string, std::vector<Json>> by_load;
    for (const Json& row : steps) by_load[row["load"]].push_back(row);
    CHECK(by_load.size() == (digits == std::string("16") ? 4 : 2));
    const char* tolerance = digits == std::string("16") ? "1e-12" : "1e-28";
    for (const auto& [load, rows] : by_load) {
      CAPTURE(load);
      const Json single = solve(replaced(bumps, "load = 1", "load = \"" + load + '"'), {"--digits", digits});
      REQUIRE(single["contact"].size() == rows.size());
      for (std::size_t k = 0; k < rows.size(); ++k) {
        for (const std::string end : {"left", "right"}) {
          CHECK(near(single["contact"][k][end]["x"], rows[k][end], tolerance));
          CHECK(single["contact"][k][end]["kind"] == rows[k][end + "_kind"]);
          CHECK(near(single["contact"][k][end]["intensity"], rows[k][end + "_intensity"], tolerance));
        }
        for (const char* key : {"effective_friction", "centre_of_pressure"}) {
          CHECK(near(single["resultants"][key], rows[k][key], tolerance));
        }
      }
    }
  }
}

TEST_CASE("a tilting indenter has its tilt in every row") {
  const Json json = solve_steps("load_at = \"0.1\"\n" + bumps, "0.5,1,2");
  for (const Json& row : json) {
    CHECK(row["tilt"].is_string());
    CHECK(near(row["centre_of_pressure"], "0.1", "1e-12"));
  }
}

TEST_CASE("a load without a solution keeps its row, the others are solved, and the exit code is 1") {
  const Finished finished = run_steps(elastic, "0.5,100,1,200", {"--format", "csv"});
  const std::string why = "the contact of an elastic indenter reaches an edge, where the half-plane idealisation fails";
  CHECK(finished.code == 1);
  CHECK(finished.err ==
        "steadyslide: -: 2 of 4 loads not solved, first of all 100: " + why + "; what was reached is printed\n");
  const auto rows = lines(finished.out);
  REQUIRE(rows.size() == 5);
  CHECK(rows[1].starts_with("0.5,1,-0."));
  CHECK(rows[2] == "100,,,,,,,,,,,,\"" + why + "\",,,,,,,,");
  CHECK(rows[3].starts_with("1,1,-0."));
  const Finished json = run_steps(elastic, "0.5,100", {"--format", "json"});
  CHECK(json.code == 1);
  CHECK(Json::parse(json.out)[1]["left"].is_null());
  CHECK(Json::parse(json.out)[1]["shortcoming"] == why);
}

TEST_CASE("a method that applies at no load is an error, and nothing is printed") {
  const Finished finished = run_steps(elastic, "100,200");
  CHECK(finished.code == 2);
  CHECK(finished.out == "");
  const Finished formula = run_steps(bumps, "1,2", {"--method", "closed-form"});
  CHECK(formula.code == 2);
  CHECK(holds(formula.err, "no closed form applies"));
}

TEST_CASE("a bar on a terminal, gone at the end; nothing elsewhere") {
  const TemporaryFolder folder;
  const Arguments arguments{"solve", "-", "--load-steps", "0.5,1", "-o", "rows"};
  const Finished shown = run_on_terminal(arguments, folder.path(), bumps);
  CHECK(shown.code == 0);
  check_erased(shown, "0/2 0 %");
  CHECK(run_program(arguments, folder.path(), bumps).err == "");
}
