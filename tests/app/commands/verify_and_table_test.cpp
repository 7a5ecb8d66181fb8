// Tests of `verify` and `table` that do not fit into the lists of answers.

#include <chrono>

#include "app/json_answers.hpp"

TEST_CASE("--list names every claim once and checks nothing") {
  const Json json = Json::parse(run_alone({"verify", "--list", "--format", "json"}).out);
  const std::string text = run_alone({"verify", "--list"}).out;
  CHECK(json["claims"].size() >= 5);
  for (const Json& claim : json["claims"]) {
    CHECK(holds("\n" + text, "\n" + claim["id"].get<std::string>() + "\n"));
    CHECK_FALSE(claim.contains("verdict"));
  }
}

TEST_CASE("8820 rows of 30 digits in less than two seconds") {
  const auto start = std::chrono::steady_clock::now();
  const Finished finished =
      run_alone(words("table --poisson=-0.5:0.45:0.05 --rear 0:2:0.1 --front 0:2:0.1 --digits 30 --format csv"));
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  CHECK(finished.code == 0);
  CHECK(lines(finished.out).size() == 8821);
#ifndef __SANITIZE_ADDRESS__
  CHECK(elapsed.count() < 2);
#endif
}
