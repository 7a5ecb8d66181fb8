// Every example file runs, and says what its header and the README say.

#include <doctest/doctest.h>

#include <algorithm>
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
                           "nearly_incompressible.toml", "elastic_indenter.toml", "wedge.toml", "rounded_wedge.toml",
                           "two_bumps.toml", "stepped_punch.toml", "tilting_punch.toml"}) {
    CAPTURE(name);
    const Json json = solve(name);
    const Json& resultants = json["resultants"];
    const Json& friction = json["problem"]["friction"]["values"];
    Rational sum = 0;
    Rational shares = 0;
    for (std::size_t k = 0; k < friction.size(); ++k) {
      sum += number(friction[k]) * number(resultants["load_share"][k]);
      shares += number(resultants["load_share"][k]);
      CHECK(number(resultants["load_share"][k]) >= 0);
    }
    CHECK(abs(sum - number(resultants["effective_friction"])) < parse_rational("1e-11"));
    CHECK(abs(shares - 1) < parse_rational("1e-11"));
    const Rational load = number(json["problem"]["load"]);
    CHECK(abs(number(resultants["normal"]) / load - 1) < parse_rational("1e-11"));
    CHECK(number(json["residuals"]["penetration"]) <= parse_rational("1e-12"));
    CHECK(number(json["residuals"]["tension"]) <= parse_rational("1e-12"));
    for (const Json& component : json["contact"]) {
      CHECK(number(component["left"]["x"]) < number(component["right"]["x"]));
      for (const char* end : {"left", "right"}) {
        CHECK(number(component[end]["intensity"]) > 0);
        const bool is_free = component[end]["kind"] == "free";
        CHECK((number(component[end]["exponent"]) > 0) == is_free);
      }
    }
    CHECK(number(json["residuals"]["equation"]) <= parse_rational("1e-12"));
    CHECK(number(json["residuals"]["load"]) <= parse_rational("1e-12"));
  }
}

TEST_CASE("the rough surface touches in as many zones as its header says, and has the friction of the README") {
  const Json shown = solve("rough_surface.toml");
  CHECK(shown["method"] == "variational");
  CHECK(shown["contact"].size() == 25);
  const Json& resultants = shown["resultants"];
  CHECK(abs(number(resultants["effective_friction"]) - parse_rational("0.243")) < parse_rational("5e-5"));
  CHECK(abs(number(resultants["load_share"][0]) - parse_rational("0.5232")) < parse_rational("5e-5"));
  CHECK(abs(number(resultants["load_share"][1]) - parse_rational("0.4768")) < parse_rational("5e-5"));
  const Finished finer = run_program(
      {"solve", "rough_surface.toml", "--method", "variational", "--cells", "65536", "--format", "json"}, folder);
  const Json fine = Json::parse(finer.out);
  CHECK(fine["contact"].size() == 36);
  CHECK(abs(number(fine["resultants"]["effective_friction"]) - parse_rational("0.243039")) < parse_rational("5e-6"));
}

TEST_CASE("two coatings: the friction of the README, sliding one way and the other") {
  const Rational forward = number(solve("two_coatings_forward.toml")["resultants"]["effective_friction"]);
  const Rational backward = number(solve("two_coatings_backward.toml")["resultants"]["effective_friction"]);
  const Rational tolerance = parse_rational("0.00005");
  CHECK(abs(forward - parse_rational("0.2828")) < tolerance);
  CHECK(abs(backward - parse_rational("0.3159")) < tolerance);
}

namespace {

/// "left_kind right_kind" of every contact component.
std::vector<std::string> kinds(const Json& json) {
  std::vector<std::string> result;
  for (const Json& component : json["contact"]) {
    result.push_back(component["left"]["kind"].get<std::string>() + " " +
                     component["right"]["kind"].get<std::string>());
  }
  return result;
}

}  // namespace

TEST_CASE("what the headers of the examples without a formula promise") {
  const Json rounded = solve("rounded_wedge.toml");
  CHECK(rounded["method"] == "riemann-hilbert");
  CHECK(rounded["singular_points"][1]["kind"] == "wedge_and_jump");
  CHECK(number(rounded["singular_points"][1]["exponent"]) < 0);
  CHECK(number(rounded["singular_points"][1]["intensity"]) > 0);

  CHECK(kinds(solve("two_bumps.toml")) == std::vector<std::string>{"free free", "free free"});
  const Finished steps =
      run_program({"solve", "two_bumps.toml", "--load-steps", "0.77,0.78", "--format", "csv"}, folder);
  CHECK(std::count(steps.out.begin(), steps.out.end(), '\n') == 4);

  CHECK(kinds(solve("stepped_punch.toml")) == std::vector<std::string>{"edge step", "free edge"});

  const Json tilting = solve("tilting_punch.toml");
  CHECK(kinds(tilting) == std::vector<std::string>{"edge edge"});
  CHECK(number(tilting["resultants"]["tilt"]) < 0);
  CHECK(abs(number(tilting["resultants"]["centre_of_pressure"]) - parse_rational("0.2")) < parse_rational("1e-12"));
  const Finished lifted = run_other({"sed", "s/^load_at = .*/load_at = \"0.8\"/", "tilting_punch.toml"}, folder);
  const Finished solved = run_program({"solve", "-", "--format", "json"}, folder, lifted.out);
  CHECK(kinds(Json::parse(solved.out)) == std::vector<std::string>{"free edge"});
}
