// Traces with typical mistakes: the wrong sign, the wrong unit, a trace that is cut too early.

#include "app/json_answers.hpp"

namespace {

struct Answer {
  int code;
  std::string err;
  Json json;
};

/// A problem with a trace of points x, height(x) on [-1, 1].
template <class Height>
Answer solve_trace(Height height, const Arguments& arguments = {}) {
  const TemporaryFolder folder;
  std::string trace;
  for (int k = -200; k <= 200; ++k) trace += std::to_string(k) + "/200," + std::to_string(height(k / 200.0)) + "\n";
  folder.write("trace.csv", trace);
  const Finished finished = folder.run(joined({"solve", "-", "--format", "json"}, arguments), problem_text("sampled"));
  return {finished.code, finished.err, Json::parse(finished.out)};
}

double bowl(double x) { return x * x / 4; }

/// The bowl with some waves; its heights are in thousandths of the unit of x.
double in_micrometres(double x) { return 1000 * (bowl(x) + 0.002 * std::sin(37 * x) + 0.001 * std::sin(91 * x + 1)); }

/// The warnings as they are on stderr.
std::string as_lines(const Json& warnings) {
  std::string result;
  for (const Json& warning : warnings) result += "steadyslide: -: warning: " + warning.get<std::string>() + "\n";
  return result;
}

bool has(const Json& warnings, const char* part) { return holds(warnings.dump(), part); }

}  // namespace

TEST_CASE("a good trace has no warning") {
  const Answer answer = solve_trace(bowl);
  CHECK(answer.code == 0);
  CHECK(answer.err == "");
  CHECK(answer.json["warnings"] == Json::array());
  CHECK(answer.json["uniqueness"]["status"] == "the only solution");
}

TEST_CASE("heights of the wrong sign: the warning names contact in the last 1 % of the support") {
  for (const double tilt : {0.0, 0.1}) {
    CAPTURE(tilt);
    const Answer answer = solve_trace([tilt](double x) { return -bowl(x) + tilt * x; });
    CHECK(answer.code == 0);
    CHECK(answer.err == as_lines(answer.json["warnings"]));
    CHECK(has(answer.json["warnings"], "contact reaches a cut end of the trace; "));
    CHECK(has(answer.json["warnings"], "all contact lies within the last 1 % of the trace; "));
  }
}

TEST_CASE("a trace that is cut too early: the warning names contact at its end") {
  const Answer answer = solve_trace([](double x) { return bowl(x) - 0.5 * x; });
  CHECK(answer.code == 0);
  REQUIRE(answer.json["warnings"].size() == 1);
  CHECK(answer.err ==
        "steadyslide: -: warning: contact reaches a cut end of the trace; what was measured ends there, the indenter "
        "may go on; x = 1\n");
}

TEST_CASE("heights in the wrong unit: slopes are steep, and a contact of one cell is no solution") {
  const std::string question =
      "slopes of the measured profile reach 6.3e2; are the units of x and of the heights right (x_unit, height_unit)?";
  const Answer accurate = solve_trace(in_micrometres);
  CHECK(accurate.code == 0);
  CHECK(accurate.json["warnings"].front() == question);
  CHECK(accurate.err == as_lines(accurate.json["warnings"]));
  const Answer answer = solve_trace(in_micrometres, {"--cells", "4096"});
  CHECK(answer.json["warnings"].back() == question);
  CHECK(answer.code == 1);
  CHECK(has(answer.json["warnings"], "ends of contact: large estimated error; more than 10 % of the contact's length"));
  CHECK(answer.json["uniqueness"]["status"] == "not_solved");
  const std::string last = answer.err.substr(as_lines(answer.json["warnings"]).size());
  CHECK(last.starts_with("steadyslide: -: the solve did not converge: the estimated error of the ends of contact is "));
  CHECK(last.ends_with(" % of the contact's length; what was reached is printed\n"));
}

TEST_CASE("the warning for a gap that is too short for its numbers gives its order of magnitude") {
  const Finished finished = run_program({"solve", "-", "--format", "json"}, ".", problem_text("pressed_notch"));
  CHECK(finished.code == 0);
  const Json json = Json::parse(finished.out);
  CHECK(json["contact"].size() == 1);
  CHECK(finished.err == as_lines(json["warnings"]));
  CHECK(has(json["warnings"], "they are too short for any place in them to have a number; x = 0 (about 1e-"));
  // A proof has to decide the sign in the corner.
  const Finished certified = run_program({"solve", "-", "--certify"}, ".", problem_text("pressed_notch"));
  CHECK(certified.code == 1);
  CHECK(holds(certified.out + certified.err, "not proved"));
}

TEST_CASE("kinks that are the rounding of measured heights have no warning; larger ones have") {
  const auto lined = [](double third) {
    std::string trace;
    for (int k = -10; k <= 10; ++k) {
      std::ostringstream height;
      height.precision(17);
      height << 0.11 * (k / 10.0) + 0.3 + (k == -3 ? third : 0);
      trace += std::to_string(k) + "/10," + height.str() + "\n";
    }
    const TemporaryFolder folder{{"trace.csv", trace}};
    const std::string problem =
        "load = 1\nload_at = \"0.01\"\n[half_space]\npoisson = \"0.3\"\n[friction]\nvalues = [\"0.2\"]\n[indenter]\n"
        "samples = \"trace.csv\"\n";
    return folder.run({"solve", "-"}, problem).err;
  };
  CHECK(holds(lined(0), "contact reaches a cut end"));
  CHECK_FALSE(holds(lined(0), "gaps over notches"));
  CHECK(holds(lined(1e-12), "gaps over notches"));
}

TEST_CASE("warnings of load steps name the load") {
  const auto turned = [](double x) { return -bowl(x) + 0.1 * x; };
  const Answer steps = solve_trace(turned, {"--load-steps", "0.01,0.02"});
  CHECK(steps.code == 0);
  CHECK(steps.err.starts_with("steadyslide: -: warning: load 0.01: "));
  CHECK(holds(steps.err, "\nsteadyslide: -: warning: load 0.02: "));
  for (const Json& row : steps.json) CHECK(has(row["warnings"], "contact reaches a cut end of the trace"));
}
