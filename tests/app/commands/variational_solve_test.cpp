// solve --method variational: against the other methods, what it does not know, and how it ends unsolved.

#include "app/json_answers.hpp"

namespace {

Json on_cells(const std::string& file, const Arguments& arguments = {}) {
  return solve_example(file, joined(arguments, {"--method", "variational"}));
}

Rational distance(const Json& a, const Json& b) { return abs(number(a) - number(b)); }

/// Of one of the 4096 cells, and half a digit of what is printed of it.
Rational reach(const Json& json) {
  const Json& support = json["problem"]["indenter"]["support"];
  return (number(support[1]) - number(support[0])) / 4096 + 0.0005_r;
}

}  // namespace

TEST_CASE("the contact's ends are those of the other methods to a cell, and the friction is theirs") {
  for (const char* file :
       {"parabola_rough_rear.toml", "two_bumps.toml", "tilting_punch.toml", "stepped_punch.toml", "wedge.toml"}) {
    CAPTURE(file);
    const Json cells = on_cells(file), exact = solve_example(file);
    CHECK(cells["method"] == "variational");
    CHECK(exact["method"] != "variational");
    CHECK(cells["problem"] == exact["problem"]);
    CHECK(cells["uniqueness"] == exact["uniqueness"]);
    REQUIRE(cells["contact"].size() == exact["contact"].size());
    for (std::size_t k = 0; k < cells["contact"].size(); ++k) {
      for (const char* end : {"left", "right"}) {
        CHECK(distance(cells["contact"][k][end]["x"], exact["contact"][k][end]["x"]) < reach(cells));
        CHECK(cells["contact"][k][end]["kind"] == exact["contact"][k][end]["kind"]);
        CHECK(cells["contact"][k][end]["exponent"] == exact["contact"][k][end]["exponent"]);
      }
    }
    const auto friction = [](const Json& json) { return json["resultants"]["effective_friction"]; };
    CHECK(distance(friction(cells), friction(exact)) < 1e-4_r);
  }
  // The control: another problem's friction and ends are told apart.
  const Json rear = on_cells("parabola_rough_rear.toml");
  const Json front = solve_example("parabola_rough_front.toml");
  CHECK(distance(rear["contact"][0]["left"]["x"], front["contact"][0]["left"]["x"]) > reach(rear));
}

TEST_CASE("more cells, a smaller error") {
  const auto error = [](const char* cells) {
    return number(on_cells("two_bumps.toml", {"--cells", cells})["estimated_error"]["ends"]);
  };
  CHECK(error("16384") < error("1024") / 8);
}
