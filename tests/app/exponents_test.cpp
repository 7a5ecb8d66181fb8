#include "app/json_answers.hpp"

namespace {

const std::string problem =
    "load = 1\n[half_space]\ngamma = \"1/2\"\n[friction]\nvalues = [2, 0]\njumps = [0]\n[indenter]\n"
    "pieces = [{to = 0, profile = \"-x\"}, {to = \"1/3\", profile = \"x\"}, {to = 1, profile = \"2*x\"}]\n";

Json exponents(const std::string& text, const std::string& digits = "16") {
  return json_of(run_alone({"exponents", "-", "--format", "json", "--digits", digits}, text));
}

}  // namespace

TEST_CASE("every place, left to right, then the free ends anywhere") {
  const auto list = exponents(problem);
  REQUIRE(list.size() == 10);
  CHECK(list[0].dump() ==
        "{\"x\":\"-1\",\"kind\":\"edge\",\"side\":\"right\",\"friction\":[\"2\"],\"exponent\":"
        "\"-0.75\",\"symbolic\":\"-1/2 - arctan(1)/pi\",\"latex\":\"" +
            std::string("-\\\\frac{1}{2}-\\\\frac{1}{\\\\pi}\\\\arctan 1") + "\"}");
  CHECK(list[1]["kind"] == "free");
  CHECK(list[1]["exponent"] == "0.25");
  CHECK(list[2]["kind"] == "wedge_and_jump");
  CHECK(list[2]["side"] == "both");
  CHECK(list[2]["friction"].dump() == "[\"2\",\"0\"]");
  CHECK(list[2]["exponent"] == "0.25");
  CHECK(list[3]["x"] == "0.3333333333333333");
  CHECK(list[3]["kind"] == "step");
  CHECK(list[6]["x"] == "anywhere");
}

TEST_CASE("a wedge without friction jump is a logarithm") {
  const auto list = exponents(
      "load = 1\nhalf_space.gamma = 0\nfriction.values = [1]\n"
      "indenter.pieces = [{to = 0, profile = \"-x\"}, {to = 1, profile = \"x\"}]\n");
  CHECK(list[2]["kind"] == "wedge");
  CHECK(list[2]["exponent"] == "log");
  CHECK(list[2]["symbolic"] == "log");
}

TEST_CASE("sliding the other way changes the sign of s") {
  const auto list = exponents("sliding = \"-x\"\n" + problem);
  CHECK(list[0]["exponent"] == "-0.25");
  CHECK(list[2]["exponent"] == "-0.25");
}

TEST_CASE("a hundred digits") {
  const std::string punch = "load = 1\nhalf_space.gamma = '1/3'\nfriction.values = [1]\nindenter.profile = 0\n";
  const auto list = exponents(punch, "100");
  const auto fifty = exponents(punch, "50");
  const std::string digits = list[0]["exponent"];
  CHECK(digits.size() >= 102);
  CHECK(digits.substr(0, 51) == fifty[0]["exponent"].get<std::string>().substr(0, 51));
}

TEST_CASE("CSV quotes what needs it, Markdown has formulas") {
  const Finished csv = run_alone({"exponents", "-", "--format", "csv"}, problem);
  CHECK(csv.out.starts_with("x,kind,side,friction,exponent,symbolic,latex\n-"));
  CHECK(holds(csv.out, "0,wedge_and_jump,both,2 0,0.25,arctan(1)/pi,"));
  CHECK(holds(run_alone({"exponents", "-", "--format", "markdown"}, problem).out, "| $-\\frac{1}{2}-"));
}

TEST_CASE("--derivation tells how each exponent comes about, in steps, and ends with the closed form") {
  const std::string punch =
      "load = 1\n[half_space]\ngamma = \"1/2\"\n[friction]\nvalues = [1, 3]\njumps = [0]\n[indenter]\nprofile = "
      "\"0\"\n";
  const Finished told = run_alone({"exponents", "-", "--derivation"}, punch);
  CHECK(told.code == 0);
  // s = 1/2 and 3/2: the determinant 1 + s_l s_r + (s_r - s_l) C = 7/4 + C, so that cot(pi lambda) = -7/4.
  check_holds(told.out, {"cot(pi lambda) = -7/4", "arctan(1/2)/pi - arctan(3/2)/pi", "1.  assume  "});
  CHECK(told.out == run_alone({"exponents", "-", "--derivation"}, punch).out);
}
