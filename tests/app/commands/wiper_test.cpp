// The wiper of docs/engineers.md: numbers for strength are the same on every mesh, within their errors.

#include "app/json_answers.hpp"

TEST_CASE("a measured wiper on few cells, on many, and to an accuracy: all numbers agree within their errors") {
  const auto solved = [](const std::string& mesh) {
    return solve_example("wiper.toml", words("--over 0.005 --max-stress --depth 0.02 " + mesh));
  };
  const Json finest = solved("--cells 262144");
  int compared = 0;
  for (const char* mesh : {"--cells 4096", "--cells 32768", ""}) {
    CAPTURE(mesh);
    const Json found = solved(mesh);
    const auto agree = [&](const Json& one, const Json& other, const char* what) {
      INFO(what, " ", one.dump(), " ", other.dump());
      CHECK(abs(number(one) - number(other)) <= error_of(one) + error_of(other));
      CHECK(error_of(one) < abs(number(one)) / 2);
      ++compared;
    };
    for (const char* key : {"friction_force", "effective_friction", "centre_of_pressure", "largest_average"}) {
      agree(found["resultants"][key], finest["resultants"][key], key);
    }
    for (const std::size_t k : {0U, 1U}) {
      agree(found["resultants"]["load_share"][k], finest["resultants"]["load_share"][k], "load share");
    }
    agree(found["largest_stress"]["von_mises"], finest["largest_stress"]["von_mises"], "von Mises");
  }
  CHECK(compared == 21);
}
