// Combinations of varied data: their number, their order and their problems, compared with explicit loops.

#include "library/sweep/combinations.hpp"

#include "library/problem_file/file_error.hpp"
#include "support/test.hpp"

using namespace steadyslide::library;

namespace {

const std::string base =
    "load = 1\n[half_space]\npoisson = 0.3\n[friction]\nvalues = [0.1, 0.2]\njumps = [0]\n[indenter]\nprofile = 0\n";

Axis axis(const std::string& path, const std::vector<std::string>& texts) {
  VariedDatum datum{path, 7, {}};
  for (const std::string& text : texts) {
    Value& value = datum.values.emplace_back();
    value.kind = Value::Kind::text;
    value.line = 7;
    value.text = text;
  }
  return {datum};
}

Combinations combinations(std::vector<Axis> axes, const std::string& text = base) {
  return {parse_document(text, "base.toml"), "base.toml", std::move(axes), "sweep.toml"};
}

}  // namespace

TEST_CASE("the last axis runs fastest, data of one axis in step") {
  Axis together = axis("friction.values[0]", {"0.3", "0.4"});
  together.push_back(axis("half_space.poisson", {"0.1", "0.2"}).front());
  const Combinations all =
      combinations({axis("load", {"1", "2", "3"}), together, axis("friction.jumps[0]", {"0", "1/2"})});
  REQUIRE(all.size() == 12);
  std::size_t n = 0;
  for (const int load : {1, 2, 3}) {
    for (const int step : {1, 2}) {
      for (const int jump : {0, 1}) {
        const steadyslide::ContactProblem problem = all.problem(n).contact;
        CHECK(problem.load() == load);
        CHECK(problem.friction().values() == std::vector<Rational>{Rational(2 + step, 10), Rational(1, 5)});
        CHECK(problem.elasticity().half_space()->poisson() == Rational(step, 10));
        CHECK(problem.friction().jumps() == std::vector<Rational>{Rational(jump, 2)});
        CHECK(all.chosen(n)[1] == all.chosen(n)[2]);
        ++n;
      }
    }
  }
}

TEST_CASE("every combination reads its own indenter where that varies, and all the same one where not") {
  const Combinations shapes = combinations({axis("indenter.profile", {"x^2", "x^4"}), axis("load", {"1", "2"})});
  CHECK(shapes.problem(1).contact.indenter().pieces()[0].profile.degree() == 2);
  CHECK(shapes.problem(2).contact.indenter().pieces()[0].profile.degree() == 4);
  const Combinations loads = combinations({axis("load", {"1", "2"})});
  CHECK(loads.problem(0).contact.indenter() == loads.problem(1).contact.indenter());
}

TEST_CASE("a datum that the base lacks is added; one that is no problem is refused by itself") {
  const Combinations all = combinations({axis("load_at", {"0.1", "1"}), axis("half_space.young", {"5"})});
  CHECK(all.problem(0).contact.load_at() == Rational(1, 10));
  CHECK(all.problem(0).contact.elasticity().half_space()->young() == 5);
  try {
    all.problem(1);
    FAIL("no error");
  } catch (const InvalidFile& invalid) {
    CHECK(std::string(invalid.what()).starts_with("sweep.toml:7: load_at: "));
    CHECK(invalid.complaint() == std::string(invalid.what()).substr(14));
  }
}

TEST_CASE("mistakes: in the base with its line, in what varies with the sweep's") {
  const auto said = [](std::vector<Axis> axes, const std::string& text = base) {
    return thrown_by([&] { combinations(std::move(axes), text); });
  };
  CHECK(
      said({axis("load", {"1"})}, "lode = 1\n" + base) ==
      "base.toml:1: unknown key; the keys of a problem file are load, load_at, sliding, units, half_space, friction, indenter, wear; "
      "'lode'");
  CHECK(
      said({axis("half_space.yong", {"1"})}) ==
      "sweep.toml:7: unknown key; the keys of half_space are poisson, young, plane, gamma, layers, base, period, symbol; 'yong'");
  CHECK(said({axis("load", {"-1", "0"})}) == "sweep.toml:7: load: load out of range; the load is positive; -1");
  CHECK(said({axis("load", {"-1", "1"})}) == "no error");
  for (const char* path : {"friction.values[2]", "friction.values[x]", "friction.values[", "load.x", "load[0]", ""}) {
    CHECK(said({axis(path, {"1"})}) == "sweep.toml:7: " + std::string(path) +
                                           ": no such datum; a path leads to a datum of the problem, like "
                                           "friction.values[0]; absent");
  }
  CHECK(said({axis("friction.values", {"1"}), axis("friction.values[0]", {"1"})}) ==
        "sweep.toml:7: friction.values[0]: varied twice; a datum is varied once; friction.values");
  CHECK(said({axis("load", {"1"}), axis("load_at", {"0"})}) == "no error");
  const std::vector<std::string> many(4000, "1");
  CHECK(said({axis("load", many), axis("half_space.young", many)}) ==
        "sweep.toml:7: half_space.young: too many problems; a sweep has at most 10000000; more");
}
