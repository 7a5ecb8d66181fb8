#include "app/problem_file/problem_file.hpp"

#include "app/problem_file/document.hpp"
#include "app/problem_file/indenter_reader.hpp"
#include "app/problem_file/input.hpp"
#include "app/problem_file/problem_reader.hpp"

namespace steadyslide::app {
namespace {

Solid read_solid(const ProblemReader& reader, const std::string& table) {
  const Rational poisson =
      reader.number(table + ".poisson", reader.required(table + ".poisson", "Poisson's ratio is required"));
  const Value* young = reader.find(table + ".young");
  const Rational modulus = young != nullptr ? reader.number(table + ".young", *young) : Rational(1);
  try {
    return {poisson, modulus};
  } catch (const InvalidData& invalid) {
    throw reader.error(invalid, table + ".");
  }
}

Plane read_plane(const ProblemReader& reader) {
  const Value* value = reader.find("half_space.plane");
  if (value == nullptr) return Plane::strain;
  const std::string& text = reader.text("half_space.plane", *value);
  if (text == "strain") return Plane::strain;
  if (text == "stress") return Plane::stress;
  throw reader.error("half_space.plane", "unknown plane", "it is strain or stress", excerpt(text));
}

Elasticity read_elasticity(const ProblemReader& reader) {
  reader.check_table("half_space");
  reader.check_keys("half_space", {"poisson", "young", "plane", "gamma"});
  const bool elastic = reader.find("indenter.elastic") != nullptr;
  if (const Value* gamma = reader.find("half_space.gamma")) {
    for (const char* key : {"half_space.poisson", "half_space.young", "half_space.plane", "indenter.elastic"}) {
      if (reader.find(key) == nullptr) continue;
      throw reader.error(key, "conflicting key", "with half_space.gamma the data are reduced and this is left out",
                         "present");
    }
    try {
      return Elasticity::reduced(reader.number("half_space.gamma", *gamma));
    } catch (const InvalidData& invalid) {
      throw reader.error(invalid, "half_space.");
    }
  }
  reader.required("half_space.poisson", "half_space has poisson or gamma");
  const Plane plane = read_plane(reader);
  const Solid half_space = read_solid(reader, "half_space");
  if (!elastic) return Elasticity(half_space, plane);
  reader.check_table("indenter.elastic");
  reader.check_keys("indenter.elastic", {"poisson", "young"});
  reader.required("indenter.elastic.young", "an elastic indenter has its own Young's modulus");
  return {half_space, read_solid(reader, "indenter.elastic"), plane};
}

FrictionProfile read_friction(const ProblemReader& reader) {
  reader.check_table("friction");
  reader.check_keys("friction", {"values", "jumps"});
  std::vector<Rational> values =
      reader.numbers("friction.values", reader.required("friction.values", "friction has values"), max_friction_values);
  std::vector<Rational> jumps;
  if (const Value* list = reader.find("friction.jumps")) {
    jumps = reader.numbers("friction.jumps", *list, max_friction_values - 1);
  }
  try {
    return FrictionProfile(std::move(values), std::move(jumps));
  } catch (const InvalidData& invalid) {
    throw reader.error(invalid);
  }
}

Sliding read_sliding(const ProblemReader& reader) {
  const Value* value = reader.find("sliding");
  if (value == nullptr) return Sliding::plus_x;
  const std::string& text = reader.text("sliding", *value);
  if (text == "+x") return Sliding::plus_x;
  if (text == "-x") return Sliding::minus_x;
  throw reader.error("sliding", "unknown direction", "it is +x or -x", excerpt(text));
}

}  // namespace

Problem parse_problem(std::string_view text, const std::string& name) {
  const Value root = parse_document(text, name);
  const ProblemReader reader(root, name);
  reader.check_keys("", {"load", "load_at", "sliding", "half_space", "friction", "indenter"});
  const Rational load = reader.number("load", reader.required("load", "a problem has a load"));
  std::optional<Rational> load_at;
  if (const Value* value = reader.find("load_at")) load_at = reader.number("load_at", *value);
  const Sliding sliding = read_sliding(reader);
  Elasticity elasticity = read_elasticity(reader);
  FrictionProfile friction = read_friction(reader);
  ReadIndenter indenter = read_indenter(reader, name);
  try {
    return {
        ContactProblem(std::move(elasticity), std::move(friction), std::move(indenter.shape), load, sliding, load_at),
        name, std::move(indenter.samples)};
  } catch (const InvalidData& invalid) {
    // The model knows pieces; a file with samples has none.
    if (indenter.samples && invalid.field() == "indenter.pieces") {
      throw reader.error("indenter.samples", invalid.what());
    }
    throw reader.error(invalid);
  }
}

Problem read_problem(const std::string& name) { return parse_problem(read_input(name), name); }

}  // namespace steadyslide::app
