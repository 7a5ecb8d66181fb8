#include "app/json_answers.hpp"

namespace {

const std::string punch =
    "load = 2\n[half_space]\npoisson = 0\n[friction]\nvalues = [0, 2]\njumps = [\"0\"]\n[indenter]\n"
    "profile = \"3\"\n";
// s = 0.1 and 0.6, radius 0.2.
const std::string parabola =
    "load = 1\n[half_space]\ngamma = \"1/2\"\n[friction]\nvalues = [0.2, 1.2]\njumps = [0]\n"
    "[indenter]\nprofile = \"x^2/0.4\"\n";

/// Is each number's error beside it, and at least a tenth (it is an estimate) of what differs from the reference? How
/// many are there?
int check_errors(const Json& object, const Json& reference) {
  int count = 0;
  if (object.is_array()) {
    for (std::size_t k = 0; k < object.size(); ++k) count += check_errors(object[k], reference[k]);
    return count;
  }
  if (!object.is_object()) return count;
  for (const auto& item : object.items()) {
    const Json& value = item.value();
    count += check_errors(value, reference[item.key()]);
    if (!value.is_string() || !object.contains(item.key() + "_error")) continue;
    CAPTURE(item.key() + " = " + value.dump());
    const Rational error = number(object[item.key() + "_error"]);
    const Rational rounding = 1e-16_r * (1 + abs(number(value)));
    CHECK(abs(number(value) - number(reference[item.key()])) <= 10 * error + rounding);
    CHECK(error >= 0);
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("JSON has the keys of the contract in their order") {
  const Json json = solve(punch, {"--at", "0,0.5", "--samples", "3"});
  CHECK(keys(json) ==
        "schema version problem method digits contact singular_points resultants samples estimated_error "
        "residuals uniqueness warnings");
  CHECK(json["schema"] == 1);
  CHECK(json["version"] == STEADYSLIDE_VERSION);
  CHECK(json["method"] == "closed-form");
  CHECK(json["digits"] == 16);
  CHECK(
      json["problem"].dump() ==
      "{\"load\":\"2\",\"sliding\":\"+x\",\"half_space\":{\"poisson\":\"0\",\"young\":\"1\",\"plane\":\"strain\"},"
      "\"friction\":{\"values\":[\"0\",\"2\"],\"jumps\":[\"0\"]},\"indenter\":{\"support\":[\"-1\",\"1\"],\"profile\":"
      "\"3\"}}");
  CHECK(keys(json["contact"][0]) == "left right");
  CHECK(keys(json["contact"][0]["left"]) == "x x_error kind exponent intensity intensity_error");
  CHECK(keys(json["singular_points"][0]) ==
        "x x_error kind exponent symbolic latex intensity intensity_error constant constant_error");
  CHECK(
      keys(json["resultants"]) ==
      "normal normal_error tangential tangential_error centre_of_pressure centre_of_pressure_error effective_friction "
      "effective_friction_error load_share load_share_error");
  CHECK(keys(json["samples"][0]) == "x traction traction_error shear shear_error gap gap_error slope slope_error");
  CHECK(json["samples"].size() == 5);
  CHECK(keys(json["estimated_error"]) == "ends traction resultants");
  CHECK(keys(json["residuals"]) == "equation load penetration tension");
  CHECK(
      json["uniqueness"].dump() ==
      "{\"status\":\"unique by theorem 1 of [Bal16]\",\"reason\":\"s = gamma f is nondecreasing towards the front\"}");
}

TEST_CASE("the problem is echoed exactly, and its echo is the same problem") {
  const Json json = solve(
      "load = \"1e-300\"\nsliding = \"-x\"\n[half_space]\npoisson = \"1/3\"\nyoung = 2.5\nplane = "
      "\"stress\"\n[friction]\nvalues = [\"1/7\", 0.25]\njumps = [\"1e-3\"]\n[indenter]\nsupport = [-3, "
      "7]\nprofile = \"(x-1)^2/6\"\nelastic = {poisson = 0.1, young = 7}\n")["problem"];
  CHECK(json.dump() ==
        "{\"load\":\"1e-300\",\"sliding\":\"-x\",\"half_space\":{\"poisson\":\"1/3\",\"young\":\"2.5\",\"plane\":"
        "\"stress\"},\"friction\":{\"values\":[\"1/"
        "7\",\"0.25\"],\"jumps\":[\"0.001\"]},\"indenter\":{\"support\":[\"-3\","
        "\"7\"],\"profile\":\"1/6*x^2 - 1/3*x + 1/6\",\"elastic\":{\"poisson\":\"0.1\",\"young\":\"7\"}}}");
}

TEST_CASE("the check values of the parabola with a jump, to 40 digits") {
  const Json forward = solve(parabola, {"--digits", "40"});
  CHECK(forward["contact"][0]["left"]["x"] == "-0.4003017752023082835874813713471545627373");
  CHECK(forward["contact"][0]["right"]["x"] == "0.2789364365421476101051427811594294453144");
  const Json backward = solve(replaced(parabola, "0.2, 1.2", "1.2, 0.2"), {"--digits", "40"});
  CHECK(backward["contact"][0]["left"]["x"] == "-0.4900056280717151697542022236678901591541");
  CHECK(backward["contact"][0]["right"]["x"] == "0.3022454527884637023227909724409309514227");
}

TEST_CASE("more digits continue fewer, and all three types agree") {
  const Json sixteen = solve(parabola, {"--at", "0.1"});
  const Json fifty = solve(parabola, {"--at", "0.1", "--digits", "50"});
  const Json hundred = solve(parabola, {"--at", "0.1", "--digits", "100"});
  const auto traction = [](const Json& json) { return json["samples"][0]["traction"].get<std::string>(); };
  CHECK(near(sixteen["samples"][0]["traction"], traction(fifty).c_str(), "1e-13"));
  CHECK(near(fifty["samples"][0]["traction"], traction(hundred).c_str(), "1e-48"));
  CHECK(traction(fifty).size() >= 50);
  CHECK(traction(hundred).size() >= 100);
}

TEST_CASE("blow-up, zero and the limits of both sides") {
  const Json json = solve(punch, {"--at=-1,0,1,-2"});
  const Json& samples = json["samples"];
  CHECK(samples[0]["traction"] == "-inf");
  CHECK(samples[0]["shear"] == "0");
  CHECK(samples[0]["slope"] == "-inf");
  // f = 0 | 2: beta = -1/4, and no shear on the left.
  CHECK(samples[1]["traction"] == "-inf");
  CHECK(samples[1]["shear"].dump() == "{\"left\":\"0\",\"right\":\"inf\"}");
  CHECK(samples[2]["traction"] == "-inf");
  CHECK(samples[2]["shear"] == "inf");
  CHECK(samples[2]["slope"] == "inf");
  CHECK(samples[3]["traction"] == "0");
  CHECK(samples[3]["gap"].is_null());
  CHECK(json["singular_points"][1]["exponent"] == "-0.25");
  CHECK(json["singular_points"][1]["symbolic"] == "-arctan(1)/pi");
}

TEST_CASE("residuals are small and honest") {
  const Json json = solve(parabola);
  CHECK(number(json["residuals"]["equation"]) <= 1e-12_r);
  CHECK(number(json["residuals"]["load"]) <= 1e-12_r);
  CHECK(json["residuals"]["penetration"] == "0");
  CHECK(json["residuals"]["tension"] == "0");
}

TEST_CASE("data that double cannot hold are solved all the same") {
  const Json json = solve(replaced(punch, "load = 2", "load = \"2e-300\""), {"--at", "0.5"});
  const Json usual = solve(punch, {"--at", "0.5"});
  CHECK(near(json["resultants"]["normal"], "2e-300", "1e-312"));
  const Rational scaled = number(json["samples"][0]["traction"]) * 1e300_r;
  CHECK(abs(scaled - number(usual["samples"][0]["traction"])) < 1e-13_r);
  CHECK(near(solve(replaced(parabola, "x^2/0.4", "x^2*1e200"))["resultants"]["normal"], "1", "1e-12"));
}

TEST_CASE("CSV: samples, two rows where limits differ, 101 by default") {
  const auto rows = lines(output(punch, {"--at=-2,0,0.5", "--format", "csv"}));
  REQUIRE(rows.size() == 5);
  CHECK(rows[0] == "x,traction,shear,gap,slope,traction_error,shear_error,gap_error,slope_error");
  CHECK(rows[1].starts_with("-2,0,0,,"));
  CHECK(rows[2] == "0,-inf,0,0,0,0,0,0,0");
  CHECK(rows[3] == "0,-inf,inf,0,0,0,0,0,0");
  CHECK(rows[4].starts_with("0.5,"));
  CHECK(lines(output(punch, {"--format", "csv"})).size() == 102);
}

TEST_CASE("text tells everything in words") {
  check_holds(output(punch, {"--at", "0"}),
              {"from x = -1 (edge) to x = 1 (edge)", "friction_jump", "effective friction", "under f = 2", "0 | inf",
               "equation", "\nunique by theorem 1 of [Bal16], s = gamma f is", "sliding towards +x"});
}

TEST_CASE("every number has its error beside it, of the same shape; it is the error of what is printed") {
  for (const std::string& problem : {punch, parabola}) {
    const Json json = solve(problem, {"--at=-1,0,0.1,2", "--samples", "3"});
    const Json exact = solve(problem, {"--at=-1,0,0.1,2", "--samples", "3", "--digits", "40"});
    int numbers = 0;
    for (const char* part : {"contact", "singular_points", "resultants"})
      numbers += check_errors(json[part], exact[part]);
    CHECK(numbers >= 14);
    CHECK(json["resultants"]["load_share"].size() == json["resultants"]["load_share_error"].size());
    for (const Json& sample : json["samples"]) {
      for (const std::string key : {"traction", "shear", "gap", "slope"}) {
        CHECK(sample[key].type() == sample[key + "_error"].type());
      }
    }
  }
}

TEST_CASE("16 digits give the doubles back: |shear| is f |traction| to the last bit") {
  const Json json = solve(parabola, {"--samples", "9"});
  for (const Json& sample : json["samples"]) {
    const double traction = std::stod(sample["traction"].get<std::string>());
    const double shear = std::stod(sample["shear"].get<std::string>());
    if (traction == 0) continue;
    const double f = std::stod(sample["x"].get<std::string>()) < 0 ? 0.2 : 1.2;
    CHECK(shear == -f * traction);
  }
}

TEST_CASE("--method closed-form is what auto takes") {
  CHECK(output(parabola, {"--method", "closed-form"}) == output(parabola));
}
