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

TEST_CASE("one claim, checked") {
  const Json json = json_of(run_alone(
      {"verify", "--claim", "gamma-r*", "--claim", "gamma-range", "--quick", "--seed", "7", "--format", "json"}));
  CHECK(json["digits"] == 50);
  CHECK(json["seed"] == 7);
  REQUIRE(json["claims"].size() == 1);
  CHECK(json["claims"][0]["id"] == "gamma-range");
  CHECK(json["claims"][0]["verdict"] == "proved");
  CHECK(json["claims"][0]["controls"]["total"] == json["claims"][0]["controls"]["refuted"]);
  CHECK(json["counts"]["proved"] == 1);
  CHECK(json["reading_notes"].empty());
  CHECK(json["reading_notes_left_out"] >= 14);
}

TEST_CASE("a claim comes with its own reading notes") {
  const Json json = Json::parse(
      run_alone({"verify", "--claim", "eq-04-flat-punch", "--quick", "--digits", "16", "--format", "json"}).out);
  REQUIRE(json["reading_notes"].size() == 1);
  CHECK(json["reading_notes"][0]["id"] == "eq-04-exponent");
  CHECK(json["reading_notes_left_out"] >= 13);
}

TEST_CASE("a pattern that no claim matches is an error") {
  const TemporaryFolder folder;
  check_refused(run_program({"verify", "--claim", "no-such-*", "-o", "result"}, folder.path()),
                "command line: --claim: no such claim; verify --list names them; 'no-such-*'");
  CHECK(folder.names().empty());
}
