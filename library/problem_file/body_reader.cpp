#include "library/problem_file/body_reader.hpp"

#include <fmt/format.h>

#include "library/problem_file/sample_file.hpp"
#include "library/problem_file/symbol_table.hpp"

namespace steadyslide::library {
namespace {

Solid read_solid(const ProblemReader& reader, const std::string& table) {
  const Rational poisson = reader.number(table + ".poisson", "Poisson's ratio is required");
  const Rational young = reader.number_if_any(table + ".young").value_or(1);
  return reader.accepted(table + ".", [&] { return Solid(poisson, young); });
}

/// Throws InvalidFile for the first of these fields that is present.
void leave_out(const ProblemReader& reader, std::initializer_list<std::string> fields, const std::string& rule) {
  for (const std::string& field : fields) {
    if (reader.find(field) != nullptr) throw reader.error(field, "conflicting key", rule, "present");
  }
}

Elasticity read_elasticity(const ProblemReader& reader) {
  if (const Value* gamma = reader.find("half_space.gamma")) {
    leave_out(reader, {"half_space.poisson", "half_space.young", "half_space.plane", "indenter.elastic"},
              "with half_space.gamma the data are reduced and this is left out");
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

std::vector<Layer> read_layers(const ProblemReader& reader, const Value& layers) {
  std::vector<Layer> result;
  for (std::size_t k = 0; k < reader.list("half_space.layers", layers, "layers", max_layers).size(); ++k) {
    const std::string field = fmt::format("half_space.layers[{}]", k);
    reader.check_table(field, {"thickness", "young", "poisson", "below"});
    const Rational thickness = reader.number(field + ".thickness", "a layer has a thickness");
    reader.required(field + ".young", "a layer has its own Young's modulus");
    const auto below = reader.choice<Interface>(field + ".below", "unknown interface", {"bonded", Interface::bonded},
                                                {"slip", Interface::slip});
    result.push_back({thickness, read_solid(reader, field), below});
  }
  return result;
}

ReadBody read_layered(const ProblemReader& reader, const Value& layers) {
  leave_out(reader, {"half_space.gamma", "half_space.period", "half_space.symbol", "indenter.elastic"},
            "a layered body has none of gamma, period, symbol and an elastic indenter");
  enum class Base { elastic, rigid };
  const auto base =
      reader.choice<Base>("half_space.base", "unknown base", {"elastic", Base::elastic}, {"rigid", Base::rigid});
  if (base == Base::rigid)
    leave_out(reader, {"half_space.poisson", "half_space.young"}, "a rigid base has no elastic constants");
  const auto plane =
      reader.choice<Plane>("half_space.plane", "unknown plane", {"strain", Plane::strain}, {"stress", Plane::stress});
  std::vector<Layer> read = read_layers(reader, layers);
  std::optional<Solid> below;
  if (base == Base::elastic) {
    reader.required("half_space.young", "the base under layers has its own Young's modulus, or is rigid");
    below = read_solid(reader, "half_space");
  }
  Body body = reader.accepted("half_space.", [&] { return Body::layered(std::move(read), std::move(below)); });
  const Solid surface = body.layers().front().solid;
  return {Elasticity(surface, plane), std::move(body)};
}

Body read_symbols(const ProblemReader& reader, const std::string& file) {
  const std::string field = file_field(reader, "half_space.symbol", {"file"});
  const SampleFile table = read_samples(reader, field, file, "table of symbols");
  std::vector<SymbolRow> rows = parse_symbols(table.text, table.path);
  return reader.accepted("half_space.", [&] { return Body::of_symbols(std::move(rows)); });
}

}  // namespace

ReadBody read_body(const ProblemReader& reader, const std::string& file) {
  reader.check_table("half_space", {"poisson", "young", "plane", "gamma", "layers", "base", "period", "symbol"});
  if (const Value* layers = reader.find("half_space.layers")) return read_layered(reader, *layers);
  leave_out(reader, {"half_space.base"}, "a base lies under layers");
  Elasticity elasticity = read_elasticity(reader);
  if (reader.find("half_space.symbol") != nullptr) {
    leave_out(reader, {"half_space.period", "indenter.elastic"},
              "a body given by symbols has no period and a rigid indenter");
    return {std::move(elasticity), read_symbols(reader, file)};
  }
  const std::optional<Rational> period = reader.number_if_any("half_space.period");
  if (!period) return {std::move(elasticity), {}};
  return {std::move(elasticity), reader.accepted("half_space.", [&] { return Body::periodic(*period); })};
}

}  // namespace steadyslide::library
