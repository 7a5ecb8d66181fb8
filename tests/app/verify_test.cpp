#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "app/process.hpp"

using namespace steadyslide::testing;
using Json = nlohmann::ordered_json;

TEST_CASE("--list names every claim once and checks nothing") {
  const TemporaryFolder folder;
  const Json json = Json::parse(run_program({"verify", "--list", "--format", "json"}, folder.path()).out);
  const std::string text = run_program({"verify", "--list"}, folder.path()).out;
  CHECK(json["claims"].size() >= 5);
  for (const Json& claim : json["claims"]) {
    CHECK(("\n" + text).find("\n" + claim["id"].get<std::string>() + "\n") != std::string::npos);
    CHECK_FALSE(claim.contains("verdict"));
  }
}

TEST_CASE("one claim, checked") {
  const TemporaryFolder folder;
  const Finished finished = run_program(
      {"verify", "--claim", "gamma-r*", "--claim", "gamma-range", "--quick", "--seed", "7", "--format", "json"},
      folder.path());
  CHECK(finished.code == 0);
  CHECK(finished.err == "");
  const Json json = Json::parse(finished.out);
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
  const TemporaryFolder folder;
  const Finished finished = run_program(
      {"verify", "--claim", "eq-04-flat-punch", "--quick", "--digits", "16", "--format", "json"}, folder.path());
  const Json json = Json::parse(finished.out);
  REQUIRE(json["reading_notes"].size() == 1);
  CHECK(json["reading_notes"][0]["id"] == "eq-04-exponent");
  CHECK(json["reading_notes_left_out"] >= 13);
}

TEST_CASE("a pattern that no claim matches is an error") {
  const TemporaryFolder folder;
  const Finished finished = run_program({"verify", "--claim", "no-such-*", "-o", "result"}, folder.path());
  CHECK(finished.err == "steadyslide: command line: --claim: no such claim; verify --list names them; 'no-such-*'\n");
  CHECK(finished.code == 2);
  CHECK(folder.names().empty());
}
