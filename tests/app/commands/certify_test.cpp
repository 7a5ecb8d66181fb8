// solve --certify: proofs, enclosed numbers and their digits, certificates, and cases without a proof.

#include "app/json_answers.hpp"

namespace {

/// Checks that every number with an error agrees with the other answer's number within both errors. Returns the number
/// of comparisons.
int check_enclosed(const Json& proved, const Json& other) {
  return sum_over_numbers(proved, other, [](const Json& a, const Json& b) {
    if (value_of(a).is_null()) return 0;
    if (holds(a.dump(), "inf")) {
      CHECK(value_of(b) == value_of(a));
      return 1;
    }
    CHECK(error_of(a) >= 0);
    CHECK(abs(number(a) - number(b)) <= error_of(a) + error_of(b));
    return 1;
  });
}

}  // namespace

TEST_CASE("the numbers of a proved solution enclose those with other digits and those of the solver") {
  for (const char* name : {"coated_punch", "parabola"}) {
    CAPTURE(name);
    const std::string problem = problem_text(name);
    const Arguments places{"--at=-2,-1,-0.5,0,0.3,1,2"};
    const Json proved = solve(problem, joined(places, {"--certify", "--digits", "40"}));
    CHECK(proved["proof"]["status"] == "proved");
    CHECK(proved["digits"] == 40);
    const Json more = solve(problem, joined(places, {"--certify", "--digits", "150"}));
    const Json solver = solve(problem, joined(places, {"--digits", "40"}));
    for (const char* part : {"contact", "singular_points", "resultants", "samples"}) {
      CHECK(check_enclosed(proved[part], more[part]) >= 4);
      CHECK(check_enclosed(proved[part], solver[part]) >= 4);
    }
    CHECK(error_of(more["resultants"]["effective_friction"]) < 1e-145_r);
  }
}

TEST_CASE("text shows proved digits, or a number with its error if none is proved") {
  const std::string text = output(problem_text("coated_punch"), {"--certify", "--digits", "60"});
  check_holds(text, {"\nproved: ", "relative errors, proved",
                     "the only solution, by the uniqueness theorem for a given attitude"});
  // More digits begin with the same digits.
  const std::string more = output(problem_text("coated_punch"), {"--certify", "--digits", "90"});
  const auto friction = [](const std::string& answer) {
    const std::size_t at = answer.find("0.", answer.find("effective friction"));
    return answer.substr(at, answer.find('\n', at) - at);
  };
  CHECK(friction(text).size() == 62);
  CHECK(friction(more).substr(0, 59) == friction(text).substr(0, 59));
}

TEST_CASE("a notch below its threshold: the gap of 1e-93 is proved, and has a certificate") {
  const TemporaryFolder folder;
  const Json proved = json_of(folder.run({"solve", "-", "--certificate", "gap.json", "--format", "json"},
                                         problem_text("notch_below_threshold")));
  REQUIRE(proved["contact"].size() == 2);
  CHECK(number(proved["contact"][1]["left"]["x"]) > 0);
  CHECK(number(proved["contact"][1]["left"]["x"]) < 1e-3_r);
  const Json certificate = Json::parse(folder.read("gap.json"));
  CHECK(certificate["certificate"] == 1);
  CHECK(certificate["kind"] == "solution");
  CHECK(certificate["points"].size() == certificate["segments"].size() + 1);
  CHECK(certificate["claims"] == Json::parse(R"({"exists": true})"));
}

TEST_CASE("a solution that is not proved is printed with the reason, exit code 1 and no certificate") {
  const TemporaryFolder folder;
  // With this place of the load the far edge carries no pressure. This is an exact threshold, which cannot be proved.
  const Finished finished = folder.run(words("solve - --certificate none.json"), problem_text("edge_without_pressure"));
  CHECK(finished.code == 1);
  CHECK(holds(finished.out, "\nnot proved: "));
  CHECK(holds(finished.err, ": not proved: "));
  CHECK(folder.names().empty());
}

TEST_CASE("load steps are proved, and all loads between them") {
  const Json rows = solve(problem_text("parabola"), words("--load-steps 0.5,1,2 --certify --digits 30"));
  std::string statuses;
  for (const Json& row : rows) {
    CHECK(row["failed_condition"].is_null());
    statuses += text_of(row["load"]) + (row["until_load"].is_null() ? " " : "-");
    CHECK(row["status"] == "proved");
    if (row["until_load"].is_null()) CHECK(error_of(row["effective_friction"]) < 1e-29_r);
  }
  CHECK(statuses == "0.5 0.5-1 1-2 ");
}

TEST_CASE("on cells load shares are enclosed and agree with the other method; if s falls nothing is proved") {
  const Json proved = solve(problem_text("parabola"), {"--method", "variational", "--cells", "1024", "--certify"});
  const Json exact = solve(problem_text("parabola"));
  CHECK(proved["bound"]["status"] == "proved");
  CHECK(keys(proved["resultants"]["centre_of_pressure"]) == "value error");  // the bound does not cover this quantity
  CHECK(check_enclosed(proved["resultants"], exact["resultants"]) >= 4);
  for (std::size_t k = 0; k < 2; ++k) {
    const Json& share = proved["resultants"]["load_share"][k];
    CHECK(keys(share) == "mid rad");
    CHECK(abs(number(share) - number(exact["resultants"]["load_share"][k])) <= error_of(share));
    CHECK(error_of(share) < 0.02_r);
  }
  const TemporaryFolder folder;
  const auto certified = [&](const char* problem) {
    return folder.run({"solve", "-", "--method", "variational", "--certificate", "cells.json"}, problem_text(problem));
  };
  const Finished falling = certified("parabola_rough_rear");
  CHECK(folder.names().empty());
  CHECK(falling.code == 1);
  CHECK_FALSE(holds(falling.err, "did not converge"));
  CHECK(holds(falling.out, "\nnot proved: "));
  CHECK(certified("parabola").code == 0);
  const Json certificate = Json::parse(folder.read("cells.json"));
  CHECK(certificate["kind"] == "cells");
  CHECK(certificate["pressures"].size() == 4096);
  CHECK(certificate["claims"]["load_share"].size() == certificate["problem"]["friction"]["values"].size());
}

TEST_CASE("a certificate for an interval of loads has boxes without gaps, and there is none across an event") {
  const TemporaryFolder folder;
  const std::string parabola = problem_text("parabola"),
                    certify = "solve - --load-steps 0.5,1 --certificate loads.json";
  out_of(folder.run(words(certify), parabola));
  const Json certificate = Json::parse(folder.read("loads.json"));
  CHECK(certificate["kind"] == "loads");
  CHECK(certificate["problem"]["loads"] == Json::parse(R"(["0.5", "1"])"));
  Json last = "0.5";
  for (const Json& box : certificate["boxes"]) {
    CHECK(box["loads"][0] == last);
    last = box["loads"][1];
  }
  CHECK(last == "1");
  // Between these loads the end of contact passes the jump: at the load 0.557387094, by bisection of its end in 50
  // digits.
  const std::string passing = replaced(parabola, "jumps = [0]", "jumps = [0.25]");
  const Finished event = folder.run(words("solve - --load-steps 0.5,2 --certificate none.json"), passing);
  CHECK(event.code == 1);
  CHECK(holds(event.err, "0.557387"));
  CHECK(holds(event.err, "the right end of contact passes the friction jump at x = 0.25"));
  CHECK(folder.names() == std::vector<std::string>{"loads.json"});
  // The result does not depend on the number of threads.
  const std::string written = folder.read("loads.json");
  const auto followed = [&](const std::string& jobs) {
    return run(passing, words("--load-steps 0.5,2 --certify" + jobs)).out;
  };
  const std::string one_by_one = followed("");
  for (const std::string jobs : {" --jobs 1", " --jobs 3"}) {
    out_of(folder.run(words(certify + jobs), parabola));
    CHECK((folder.read("loads.json") == written));
    CHECK(followed(jobs) == one_by_one);
  }
}
