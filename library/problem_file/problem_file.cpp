#include "library/problem_file/problem_file.hpp"

#include <fmt/format.h>

#include "library/problem_file/body_reader.hpp"
#include "library/problem_file/input_file.hpp"
#include "library/problem_file/problem_reader.hpp"
#include "library/problem_file/sample_file.hpp"
#include "library/problem_file/wear_reader.hpp"

namespace steadyslide::library {
namespace {

struct ReadFriction {
  FrictionProfile profile;
  std::optional<std::string> file{};
};

/// Reads a friction table, too, for the support of `indenter` and in its unit of length.
ReadFriction read_friction(const ProblemReader& reader, const std::string& name, const ReadIndenter& indenter) {
  reader.check_table("friction", {"values", "jumps", "samples"});
  const std::string table = "friction.samples";
  if (reader.find(table) == nullptr) {
    reader.required("friction.values", "friction has values, or samples");
    std::vector<Rational> values = reader.numbers("friction.values", max_friction_values);
    std::vector<Rational> jumps = reader.numbers("friction.jumps", max_friction_values - 1);
    return {reader.accepted("", [&] { return FrictionProfile(std::move(values), std::move(jumps)); })};
  }
  for (const std::string key : {"values", "jumps"}) {
    if (reader.find("friction." + key) == nullptr) continue;
    throw reader.error("friction." + key, "conflicting key", "friction has values and jumps, or samples",
                       "samples and " + key);
  }
  const std::string file = file_field(reader, table, {"file", "x_unit"});
  Rational unit = 1;
  if (const std::string given = file == table ? "" : length_unit(reader, table + ".x_unit"); !given.empty()) {
    const std::string& problem_unit = indenter.measured ? indenter.measured->x_unit : "";
    if (problem_unit.empty()) {
      throw reader.error(table + ".x_unit", "no unit of length",
                         "x is brought into the unit that indenter.samples.x_unit names", given);
    }
    unit = unit_ratio(given, problem_unit);
  }
  const SampleFile samples = read_samples(reader, file, name, "friction table");
  const Support support{indenter.shape.left(), indenter.shape.right()};
  const std::string& given = reader.find(file)->text;
  return {parse_friction_table(samples.text, samples.path, support, unit), is_table(given) ? "" : given};
}

/// Returns the name of a unit in the table `units`; empty if it is absent.
std::string unit_name(const ProblemReader& reader, const std::string& field) {
  const Value* value = reader.find(field);
  if (value == nullptr) return "";
  const std::string& name = reader.text(field, *value);
  constexpr std::size_t longest = 16;
  // one_line() changes control characters, bytes that are not UTF-8, and long words.
  if (name.empty() || name.size() > longest || one_line(name) != name)
    throw reader.error(field, "not a unit", fmt::format("a unit has 1 to {} bytes, on one line", longest),
                       excerpt(name));
  return name;
}

Units read_units(const ProblemReader& reader, const std::string& x_unit) {
  if (reader.find("units") == nullptr) return {x_unit, ""};
  reader.check_table("units", {"length", "force"});
  Units units{unit_name(reader, "units.length"), unit_name(reader, "units.force")};
  if (units.length.empty()) units.length = x_unit;
  if (x_unit.empty() || units.length == x_unit) return units;
  throw reader.error("units.length", "conflicting unit", "indenter.samples.x_unit is the unit of length, " + x_unit,
                     excerpt(units.length));
}

/// `whole`: load and friction are required. `same_indenter`: null, or a problem with the same [indenter].
Punch read(const Value& root, const std::string& name, bool whole, const Problem* same_indenter = nullptr) {
  const ProblemReader reader(root, name);
  reader.check_keys("", {"load", "load_at", "sliding", "units", "half_space", "friction", "indenter", "wear"});
  const bool has_load = whole || reader.find("load") != nullptr;
  const bool has_friction = whole || reader.find("friction") != nullptr;
  const Rational load = has_load ? reader.number("load", "a problem has a load") : Rational(1);
  const std::optional<Rational> load_at = reader.number_if_any("load_at");
  const auto sliding =
      reader.choice<Sliding>("sliding", "unknown direction", {"+x", Sliding::plus_x}, {"-x", Sliding::minus_x});
  ReadBody body = read_body(reader, name);
  ReadIndenter indenter = same_indenter != nullptr
                              ? ReadIndenter{same_indenter->contact.indenter(), same_indenter->measured}
                              : read_indenter(reader, name);
  Units units = read_units(reader, indenter.measured ? indenter.measured->x_unit : "");
  ReadFriction friction = has_friction ? read_friction(reader, name, indenter) : ReadFriction{FrictionProfile({0})};
  try {
    ContactProblem contact(std::move(body.elasticity), std::move(friction.profile), std::move(indenter.shape), load,
                           sliding, load_at, std::move(body.body));
    std::optional<Wear> wear = read_wear(reader, contact);
    return {{std::move(contact), name, std::move(indenter.measured), std::move(friction.file), std::move(units),
             std::move(wear)},
            has_friction};
  } catch (const InvalidData& invalid) {
    // The model speaks of pieces; a file with samples has none.
    const bool of_samples = indenter.measured && invalid.field() == "indenter.pieces";
    throw reader.error(of_samples ? "indenter.samples" : invalid.field(), invalid.what());
  }
}

}  // namespace

Problem problem_of(const Value& document, const std::string& name, const Problem* same_indenter) {
  return read(document, name, true, same_indenter).problem;
}

Problem parse_problem(std::string_view text, const std::string& name) {
  return problem_of(parse_document(text, name), name);
}

Problem read_problem(const std::string& name) { return parse_problem(read_input(name, "a problem file"), name); }

Punch read_punch(const std::string& name) {
  return read(parse_document(read_input(name, "a problem file"), name), name, false);
}

}  // namespace steadyslide::library
