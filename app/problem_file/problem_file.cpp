#include "app/problem_file/problem_file.hpp"

#include "app/problem_file/document.hpp"
#include "app/problem_file/indenter_reader.hpp"
#include "app/problem_file/input.hpp"
#include "app/problem_file/problem_reader.hpp"

namespace steadyslide::app {
namespace {

Solid read_solid(const ProblemReader& reader, const std::string& table) {
  const Rational poisson = reader.number(table + ".poisson", "Poisson's ratio is required");
  const Rational young = reader.number_if_any(table + ".young").value_or(1);
  return reader.accepted(table + ".", [&] { return Solid(poisson, young); });
}

Elasticity read_elasticity(const ProblemReader& reader) {
  reader.check_table("half_space", {"poisson", "young", "plane", "gamma"});
  if (const Value* gamma = reader.find("half_space.gamma")) {
    for (const char* key : {"half_space.poisson", "half_space.young", "half_space.plane", "indenter.elastic"}) {
      if (reader.find(key) == nullptr) continue;
      throw reader.error(key, "conflicting key", "with half_space.gamma the data are reduced and this is left out",
                         "present");
    }
    return reader.accepted("half_space.",
                           [&] { return Elasticity::reduced(reader.number("half_space.gamma", *gamma)); });
  }
  reader.required("half_space.poisson", "half_space has poisson or gamma");
  const auto plane =
      reader.choice<Plane>("half_space.plane", "unknown plane", {"strain", Plane::strain}, {"stress", Plane::stress});
  const Solid half_space = read_solid(reader, "half_space");
  if (reader.find("indenter.elastic") == nullptr) return Elasticity(half_space, plane);
  reader.check_table("indenter.elastic", {"poisson", "young"});
  reader.required("indenter.elastic.young", "an elastic indenter has its own Young's modulus");
  return {half_space, read_solid(reader, "indenter.elastic"), plane};
}

FrictionProfile read_friction(const ProblemReader& reader) {
  reader.check_table("friction", {"values", "jumps"});
  reader.required("friction.values", "friction has values");
  std::vector<Rational> values = reader.numbers("friction.values", max_friction_values);
  std::vector<Rational> jumps = reader.numbers("friction.jumps", max_friction_values - 1);
  return reader.accepted("", [&] { return FrictionProfile(std::move(values), std::move(jumps)); });
}

}  // namespace

Problem parse_problem(std::string_view text, const std::string& name) {
  const Value root = parse_document(text, name);
  const ProblemReader reader(root, name);
  reader.check_keys("", {"load", "load_at", "sliding", "half_space", "friction", "indenter"});
  const Rational load = reader.number("load", "a problem has a load");
  const std::optional<Rational> load_at = reader.number_if_any("load_at");
  const auto sliding =
      reader.choice<Sliding>("sliding", "unknown direction", {"+x", Sliding::plus_x}, {"-x", Sliding::minus_x});
  Elasticity elasticity = read_elasticity(reader);
  FrictionProfile friction = read_friction(reader);
  ReadIndenter indenter = read_indenter(reader, name);
  try {
    return {
        ContactProblem(std::move(elasticity), std::move(friction), std::move(indenter.shape), load, sliding, load_at),
        name, std::move(indenter.measured)};
  } catch (const InvalidData& invalid) {
    // The model knows pieces; a file with samples has none.
    const bool of_samples = indenter.measured && invalid.field() == "indenter.pieces";
    throw reader.error(of_samples ? "indenter.samples" : invalid.field(), invalid.what());
  }
}

Problem read_problem(const std::string& name) { return parse_problem(read_input(name), name); }

}  // namespace steadyslide::app
