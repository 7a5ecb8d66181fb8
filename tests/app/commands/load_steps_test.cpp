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
    const Json &row = json[k], &before = json[k - 1];
    CHECK((number(row["left"]) < number(before["left"]) || row["left_kind"] == "edge"));
    CHECK((number(row["right"]) > number(before["right"]) || row["right_kind"] == "edge"));
  }
  CHECK(json[0]["left_kind"] == "free");
  CHECK(json[29]["left_kind"] == "edge");
}

TEST_CASE("each row has the results of a single solve, for every order of the loads") {
  for (const auto& [digits, loads, count, tolerance] :
       {std::tuple("16", "1,0.3,0.77,0.9", 4U, "1e-12"), {"30", "1,0.3", 2U, "1e-28"}}) {
    std::map<std::string, std::vector<Json>> by_load;
    for (const Json& row : solve_steps(bumps, loads, {"--digits", digits}))
      by_load[text_of(row["load"])].push_back(row);
    CHECK(by_load.size() == count);
    for (const auto& of_load : by_load) {
      CAPTURE(of_load.first);
      const auto& [load, rows] = of_load;
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
        for (const std::size_t i : {0U, 1U}) {
          CHECK(near(single["resultants"]["load_share"][i], rows[k]["load_share"][i], tolerance));
        }
      }
    }
  }
}

TEST_CASE("a progress bar is shown on a terminal only, and erased at the end") {
  const TemporaryFolder folder;
  const Arguments arguments{"solve", "-", "--load-steps", "0.5,1", "-o", "rows"};
  const Finished shown = run_on_terminal(arguments, folder.path(), bumps);
  CHECK(shown.code == 0);
  check_erased(shown, "0/2 0 %");
  CHECK(folder.run(arguments, bumps).err == "");
}
