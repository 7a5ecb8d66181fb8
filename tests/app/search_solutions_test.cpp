// solve --search-solutions: one solution or several, in three formats.

#include "app/json_answers.hpp"

namespace {

Finished search(const Arguments& arguments) {
  return run_example("two_bumps.toml", joined({"--cells", "512"}, arguments));
}

}  // namespace

TEST_CASE("JSON: every start agrees, and the Riemann-Hilbert method refines what it has found") {
  const Json json = json_of(search({"--search-solutions", "6", "--format", "json"}));
  CHECK(keys(json) == "schema version problem search solutions uniqueness warnings");
  CHECK(json["search"] == Json{{"starts", 6}, {"unsolved", 0}, {"agreed", true}, {"different_refinements", 1}});
  REQUIRE(json["solutions"].size() == 1);
  const Json& solution = json["solutions"][0];
  CHECK(solution["times"] == 6);
  CHECK(solution["variational"]["method"] == "variational");
  CHECK(solution["refined"]["method"] == "riemann-hilbert");
  for (const char* route : {"variational", "refined"}) {
    CHECK(solution[route]["contact"].size() == 2);
    CHECK(solution[route]["residuals"]["equation"].is_string());
    CHECK(solution[route]["estimated_error"]["ends"].is_string());
    CHECK_FALSE(solution[route].contains("samples"));
  }
  CHECK(json["uniqueness"]["status"] == "unique by theorem 1 of [Bal16]");
}

TEST_CASE("text: how many starts, how often each solution, its zones") {
  check_holds(search({"--search-solutions", "6", "--digits", "6"}).out,
              {"\n6 starts, one solution\n\nsolution 1, met 6 times, on cells\n  from x = -1.1",
               "\n  residuals             equation ",
               "\nrefined by the Riemann-Hilbert method\n  from x = -1.16388 (free) to x = -0.809503 (free)\n",
               "\nunique by theorem 1 of [Bal16], "});
}

TEST_CASE("CSV: one row for each solution and component") {
  const std::string rows = search({"--search-solutions", "2", "--format", "csv"}).out;
  CHECK(rows.starts_with(
      "solution,times,component,left,left_kind,left_intensity,right,right_kind,right_intensity,"
      "effective_friction,centre_of_pressure,load_share,tilt,equation,load,penetration,tension,refined,left_error,"
      "left_intensity_error,right_error,right_intensity_error,effective_friction_error,"
      "centre_of_pressure_error,load_share_error,tilt_error\n"
      "1,2,1,-1.1"));
  CHECK(lines(rows).size() == 3);
  CHECK(holds(rows, "\n1,2,2,0."));
}

TEST_CASE("no start leads to a solution: exit code 1") {
  const Finished finished = search({"--search-solutions", "2", "--iterations", "1", "--format", "json"});
  CHECK(finished.code == 1);
  CHECK(finished.err == "steadyslide: two_bumps.toml: the search found no solution: none of 2 starts led to one\n");
  CHECK(Json::parse(finished.out)["search"] ==
        Json{{"starts", 2}, {"unsolved", 2}, {"agreed", false}, {"different_refinements", 0}});
  CHECK(Json::parse(finished.out)["uniqueness"]["status"] == "not_solved");
}

TEST_CASE("several solutions on few cells, whose refinements are one") {
  const std::string problem =
      "load = \"1/2\"\n[half_space]\ngamma = \"1/2\"\n[friction]\nvalues = [\"17\", \"0\"]\njumps = [\"0\"]\n"
      "[indenter]\nprofile = \"x^4 + 2*x^2 - x\"\n";
  check_holds(run(problem, {"--search-solutions", "60", "--cells", "16"}).out,
              {"60 starts, ", "\nsolution 2, met ",
               "\nthe refinements are one solution: more cells tell whether there are several\n",
               "\nuniqueness: not covered, "});
}
