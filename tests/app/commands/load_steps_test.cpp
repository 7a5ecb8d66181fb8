// solve --load-steps: one row for each load and contact component.

#include "app/json_answers.hpp"

namespace {

const std::string bumps = problem_text("bumps");

Json solve_steps(const std::string& problem, const std::string& loads, const Arguments& arguments = {}) {
  return solve(problem, joined({"--load-steps", loads}, arguments));
}

}  // namespace

TEST_CASE("under a parabola the ends move outwards with the load, also where it reaches the edges") {
  const Json json = solve_steps(problem_text("crushed_parabola"), "0.1:3:0.1");
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
        for (const std::size_t i : {0, 1}) {
          CHECK(near(single["resultants"]["load_share"][i], rows[k]["load_share"][i], tolerance));
        }
      }
    }
  }
}

TEST_CASE("a bar on a terminal, gone at the end; nothing elsewhere") {
  const TemporaryFolder folder;
  const Arguments arguments{"solve", "-", "--load-steps", "0.5,1", "-o", "rows"};
  const Finished shown = run_on_terminal(arguments, folder.path(), bumps);
  CHECK(shown.code == 0);
  check_erased(shown, "0/2 0 %");
  CHECK(folder.run(arguments, bumps).err == "");
}
