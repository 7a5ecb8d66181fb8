// Every example file runs, and says what its header and the README say.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/process.hpp"
#include "model/rational.hpp"

using namespace steadyslide;
using namespace steadyslide::testing;
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

const fs::path folder = STEADYSLIDE_EXAMPLES;

Json solve(const std::string& name) {
  const Finished finished = run_program({"solve", name, "--format", "json"}, folder);
  CHECK(finished.err == "");
  REQUIRE(finished.code == 0);
  return Json::parse(finished.out);
}

Rational number(const Json& text) { return parse_rational(text.get<std::string>()); }

/// The commands that an example's header shows, as arguments.
std::vector<std::vector<std::string>> commands(const fs::path& file) {
  std::vector<std::vector<std::string>> result;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("#   steadyslide ", 0) != 0) continue;
    std::istringstream words(line.substr(16));
    std::vector<std::string> arguments;
    for (std::string word; words >> word;) arguments.push_back(word);
    result.push_back(arguments);
  }
  return result;
}

}  // namespace

TEST_CASE("every problem file: its command runs, its exponents are found, and it is in the README") {
  std::ifstream stream(folder / "README.md");
  const std::string readme(std::istreambuf_iterator<char>(stream), {});
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    const std::string name = entry.path().filename();
    CAPTURE(name);
    CHECK(readme.find("(" + name + ")") != std::string::npos);
    CHECK(run_program({"exponents", name}, folder).code == 0);
    const auto shown = commands(entry.path());
    REQUIRE(shown.size() == 1);
    const Finished finished = run_program(shown[0], folder.parent_path());
    CHECK(finished.err == "");
    CHECK(finished.code == 0);
  }
  CHECK(count >= 6);
}

TEST_CASE("solved examples: effective friction is the sum of f times load share, residuals are small") {
  for (const char* name : {"flat_punch.toml", "two_coatings_forward.toml", "two_coatings_backward.toml",
                           "three_jumps.toml", "parabola.toml", "parabola_rough_front.toml", "parabola_rough_rear.toml",
                           "nearly_incompressible.toml", "elastic_indenter.toml"}) {
    CAPTURE(name);
    const Json json = solve(name);
    const Json& resultants = json["resultants"];
    const Json& friction = json["problem"]["friction"]["values"];
    Rational sum = 0;
    for (std::size_t k = 0; k < friction.size(); ++k) sum += number(friction[k]) * number(resultants["load_share"][k]);
    CHECK(abs(sum - number(resultants["effective_friction"])) < parse_rational("1e-11"));
    CHECK(number(json["residuals"]["equation"]) <= parse_rational("1e-12"));
    CHECK(number(json["residuals"]["load"]) <= parse_rational("1e-12"));
  }
}

TEST_CASE("two coatings: the friction of the README, sliding one way and the other") {
  const Rational forward = number(solve("two_coatings_forward.toml")["resultants"]["effective_friction"]);
  const Rational backward = number(solve("two_coatings_backward.toml")["resultants"]["effective_friction"]);
  const Rational tolerance = parse_rational("0.00005");
  CHECK(abs(forward - parse_rational("0.2828")) < tolerance);
  CHECK(abs(backward - parse_rational("0.3159")) < tolerance);
}
