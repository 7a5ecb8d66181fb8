// Every example file runs, and its output agrees with its header and the README.

#include <filesystem>

#include "app/json_answers.hpp"

namespace fs = std::filesystem;

namespace {

const fs::path folder = STEADYSLIDE_EXAMPLES;

/// Returns the commands in an example's header, as arguments.
std::vector<Arguments> commands(const fs::path& file) {
  std::vector<Arguments> result;
  for (const std::string& line : lines(file_text(file.string()))) {
    if (line.starts_with("#   steadyslide ")) result.push_back(words(line.substr(16)));
  }
  return result;
}

}  // namespace

TEST_CASE("every problem file: its command runs, its exponents are found, and it is in the README") {
  const std::string readme = file_text((folder / "README.md").string());
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    const std::string name = entry.path().filename();
    CAPTURE(name);
    CHECK(holds(readme, "(" + name + ")"));
    const bool is_sweep = name.starts_with("sweep_");  // a sweep uses the problem of another example
    CHECK((is_sweep || run_program({"exponents", name}, folder).code == 0));
    const auto shown = commands(entry.path());
    REQUIRE(shown.size() == 1);
    out_of(run_program(shown[0], folder.parent_path()));
  }
  CHECK(count >= 6);
}

TEST_CASE("solved examples: effective friction is the sum of f times load share, and residuals are small") {
  for (const char* name : {"flat_punch.toml", "two_coatings_forward.toml", "two_coatings_backward.toml",
                           "three_jumps.toml", "parabola.toml", "parabola_rough_front.toml", "parabola_rough_rear.toml",
                           "nearly_incompressible.toml", "elastic_indenter.toml", "wedge.toml", "rounded_wedge.toml",
                           "two_bumps.toml", "stepped_punch.toml", "tilting_punch.toml", "striped_wave.toml"}) {
    CAPTURE(name);
    const Json json = solve_example(name);
    const Json &resultants = json["resultants"], &friction = json["problem"]["friction"]["values"];
    Rational sum = 0, shares = 0;
    for (std::size_t k = 0; k < friction.size(); ++k) {
      sum += number(friction[k]) * number(resultants["load_share"][k]);
      shares += number(resultants["load_share"][k]);
      CHECK(number(resultants["load_share"][k]) >= 0);
    }
    CHECK(abs(sum - number(resultants["effective_friction"])) < 1e-11_r);
    CHECK(abs(shares - 1) < 1e-11_r);
    const Rational load = number(json["problem"]["load"]);
    CHECK(abs(number(resultants["normal"]) / load - 1) < 1e-11_r);
    CHECK(abs(number(resultants["friction_force"]) / load - sum) < 1e-11_r);
    for (const Json& residual : json["residuals"]) CHECK(number(residual) <= 1e-12_r);
    for (const Json& component : json["contact"]) {
      CHECK(number(component["left"]["x"]) < number(component["right"]["x"]));
      for (const char* end : {"left", "right"}) {
        CHECK(number(component[end]["intensity"]) > 0);
        const bool is_free = component[end]["kind"] == "free";
        CHECK((number(component[end]["exponent"]) > 0) == is_free);
      }
    }
  }
}

TEST_CASE("the tilting punch lifts off at the place of the load that its header gives") {
  const Finished lifted = run_other({"sed", "s/^load_at = .*/load_at = \"0.8\"/", "tilting_punch.toml"}, folder);
  const Json contact = solve(lifted.out)["contact"];
  REQUIRE(contact.size() == 1);
  CHECK(contact[0]["left"]["kind"] == "free");
  CHECK(contact[0]["right"]["kind"] == "edge");
}
