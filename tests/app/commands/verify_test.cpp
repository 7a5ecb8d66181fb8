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
