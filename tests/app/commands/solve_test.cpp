#include "app/json_answers.hpp"

namespace {

const std::string punch = problem_text("punch"), parabola = problem_text("parabola");
const std::string coated_punch = problem_text("coated_punch");

/// Checks that each number's error is at least a tenth of its difference from the reference; the error is an estimate.
/// Returns the number of comparisons.
int check_errors(const Json& json, const Json& reference) {
  return sum_over_numbers(json, reference, [](const Json& a, const Json& b) {
    CHECK(keys(a) == "value error");
    if (a["value"].is_null()) return 0;
    if (a["value"] == "inf") {  // an exact number
      CHECK(b["value"] == "inf");
      return 0;
    }
    const Rational rounding = 1e-16_r * (1 + abs(number(a)));
    CHECK(abs(number(a) - number(b)) <= 10 * error_of(a) + rounding);
    CHECK(error_of(a) >= 0);
    return 1;
  });
}

}  // namespace

TEST_CASE("data beyond the range of double are solved") {
  const Json json = solve(replaced(punch, "load = 2", "load = \"2e-300\""), {"--at", "0.5"});
  const Json usual = solve(punch, {"--at", "0.5"});
  CHECK(near(json["resultants"]["normal"], "2e-300", "1e-312"));
  const Rational scaled = number(json["samples"][0]["traction"]) * 1e300_r;
  CHECK(abs(scaled - number(usual["samples"][0]["traction"])) < 1e-13_r);
}

TEST_CASE("every number has its error beside it, which is the error of the printed number") {
  for (const std::string& problem : {punch, parabola}) {
    const Json json = solve(problem, {"--at=-1,0,0.1,2", "--samples", "3"});
    const Json exact = solve(problem, {"--at=-1,0,0.1,2", "--samples", "3", "--digits", "40"});
    int numbers = 0;
    for (const char* part : {"contact", "singular_points", "resultants"})
      numbers += check_errors(json[part], exact[part]);
    CHECK(numbers >= 14);
    CHECK(json["version"] == STEADYSLIDE_VERSION);
    for (const Json& sample : json["samples"]) {
      for (const std::string key : {"traction", "shear", "gap", "slope"}) {
        const bool has_limits = keys(sample[key]) == "left right";
        CHECK((is_number(sample[key]) || (has_limits && is_number(sample[key]["left"]))));
      }
    }
  }
}

TEST_CASE("16 digits give the doubles back: |shear| is f |traction| to the last bit") {
  const Json json = solve(parabola, {"--samples", "9"});
  for (const Json& sample : json["samples"]) {
    const double traction = real(sample["traction"]), shear = real(sample["shear"]);
    if (traction == 0) continue;
    const double f = real(sample["x"]) < 0 ? 0.2 : 1.2;
    CHECK(shear == -f * traction);
  }
}

TEST_CASE("a solve that does not converge writes its state and one line with the reason") {
  const TemporaryFolder folder;
  const Finished json = folder.run({"solve", "-", "--method", "riemann-hilbert", "--format", "json", "-o", "result"},
                                   problem_text("tiny_step"));
  CHECK(json.code == 1);
  CHECK(json.out == "");
  CHECK(json.err.starts_with("steadyslide: -: the solve did not converge: "));
  CHECK(json.err.ends_with("; what was reached is printed\n"));
  CHECK(times(json.err, "\n") == 1);
  CHECK(Json::parse(folder.read("result"))["contact"].size() >= 1);
}

TEST_CASE("tilt: only with load_at, and the pressure's centre lies under the load") {
  for (const char* at : {"-0.4", "0", "0.3", "0.85"}) {
    CAPTURE(at);
    const std::string tilting = "load_at = \"" + std::string(at) + "\"\n" + coated_punch;
    const Json json = solve(tilting);
    CHECK(near(json["resultants"]["centre_of_pressure"], at, "1e-12"));
    CHECK(holds(run(tilting).out, "  tilt "));
    CHECK(json["uniqueness"]["reason"] == "uniqueness theorem for a given line of action");
    // The same problem with the slope in the profile, and with an indenter that cannot tilt.
    const std::string tilt = text_of(json["resultants"]["tilt"]["value"]);
    const Json fixed = solve(replaced(coated_punch, "profile = \"0\"", "profile = \"" + tilt + "*x\""));
    CHECK(near(fixed["resultants"]["centre_of_pressure"], at, "1e-11"));
    CHECK(near(fixed["resultants"]["effective_friction"], json["resultants"]["effective_friction"], "1e-11"));
  }
}

TEST_CASE("text shows ten of many load shares, other formats show all") {
  const auto coatings = [](int values) {
    std::string friction = "0.1", jumps;
    for (int k = 1; k < values; ++k) {
      friction += ", 0." + std::to_string(k % 8 + 1);
      jumps += (k == 1 ? "\"" : ", \"") + std::to_string(2 * k - values) + "/" + std::to_string(values) + "\"";
    }
    return "load = 1\n[half_space]\npoisson = 0.3\n[friction]\nvalues = [" + friction + "]\njumps = [" + jumps +
           "]\n[indenter]\nprofile = 0\n";
  };
  const auto told = [](const std::string& text) {
    int count = 0;
    for (std::size_t at = 0; (at = text.find(" under f = ", at)) != text.npos; ++at) ++count;
    return count;
  };
  const std::string ten = output(coatings(10));
  CHECK(told(ten) == 10);
  CHECK(times(ten, "... and 1 more") == 1);  // of eleven singular points
  const std::string twelve = output(coatings(12));
  CHECK(told(twelve) == 10);
  CHECK(holds(twelve, "                        ... and 2 more (JSON has all)\n"));
  CHECK(told(output(coatings(12), {"--both-directions"})) == 20);
  CHECK(Json::parse(output(coatings(12), {"--format", "json"})).at("resultants").at("load_share").size() == 12);
}
