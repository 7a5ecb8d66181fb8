#include "app/results/solve_json.hpp"

#include "app/embedded.hpp"
#include "app/results/solve_writers.hpp"

namespace steadyslide::app {
namespace {

using Json = nlohmann::ordered_json;

/// An array of json_of(item) for each item.
template <class List, class JsonOf>
Json array(const List& list, JsonOf json_of) {
  Json result = Json::array();
  for (const auto& one : list) result.push_back(json_of(one));
  return result;
}

Json numbers(const std::vector<Rational>& values) { return array(values, exact_text); }

Json json_of(const std::string& text) { return text_json(text); }
Json json_of(const NumberText& number) { return number_json(number); }
Json json_of(const Json& json) { return json; }
Json json_of(const std::vector<NumberText>& list) { return array(list, number_json); }

Json json_of(const IntervalText& interval) {
  return {{"from", decimal_json(interval.from)}, {"to", decimal_json(interval.to)}};
}

Json json_of(const LimitText& limits) {
  if (!limits.two_sided()) return number_json(limits.left);
  return {{"left", number_json(limits.left)}, {"right", number_json(limits.right)}};
}

/// An object with more keys, each followed by its value.
template <class Value, class... More>
Json with(Json json, const char* key, const Value& value, const More&... more) {
  json[key] = json_of(value);
  if constexpr (sizeof...(more) > 0) return with(std::move(json), more...);
  return json;
}

Json solid(const Solid& body) { return {{"poisson", exact_text(body.poisson())}, {"young", exact_text(body.young())}}; }

Json half_space(const Elasticity& elasticity, const Body& body) {
  Json json;
  if (elasticity.half_space()) {
    json = solid(*elasticity.half_space());
    json["plane"] = elasticity.plane() == Plane::strain ? "strain" : "stress";
  } else {
    json["gamma"] = exact_text(elasticity.gamma());
  }
  if (body.period()) json["period"] = exact_text(*body.period());
  if (body.symbols()) json["symbol"] = {{"rows", body.symbols()->size()}};
  if (body.layers().empty()) return json;
  Json layered{{"plane", json["plane"]}, {"base", body.base() ? "elastic" : "rigid"}};
  if (body.base()) layered.update(solid(*body.base()));
  for (const Layer& layer : body.layers()) {
    Json of_layer{{"thickness", exact_text(layer.thickness)}};
    of_layer.update(solid(layer.solid));
    of_layer["below"] = layer.below == Interface::bonded ? "bonded" : "slip";
    layered["layers"].push_back(std::move(of_layer));
  }
  return layered;
}

Json indenter(const ContactProblem& problem, const std::optional<MeasuredProfile>& measured) {
  const Indenter& shape = problem.indenter();
  Json json{{"support", numbers({shape.left(), shape.right()})}};
  if (measured) {
    // Only the name of the trace: its pieces can be much longer than the results.
    json["samples"] = measured->file;
    json["points"] = measured->points;
    if (!measured->x_unit.empty()) json["x_unit"] = measured->x_unit;
    if (!measured->height_unit.empty()) json["height_unit"] = measured->height_unit;
    if (measured->flip) json["flip"] = true;
    if (const auto& trend = measured->trend) {
      json["detrend"] = {{"taken_off", trend->kind == library::Detrend::mean ? "mean" : "line"},
                         {"height", exact_text(trend->height)},
                         {"slope", exact_text(trend->slope)}};
    }
    if (measured->cutoff) json["filter"] = {{"kind", "gauss"}, {"cutoff", exact_text(*measured->cutoff)}};
    if (measured->interpolation == library::Interpolation::spline) json["interpolate"] = "spline";
  } else if (!shape.harmonics().empty()) {
    for (const Harmonic& term : shape.harmonics()) {
      json["harmonics"].push_back({{"n", term.n}, {"cos", exact_text(term.cosine)}, {"sin", exact_text(term.sine)}});
    }
  } else if (shape.pieces().size() == 1) {
    json["profile"] = to_string(shape.pieces().front().profile);
  } else {
    for (const Indenter::Piece& piece : shape.pieces()) {
      json["pieces"].push_back({{"to", exact_text(piece.to)}, {"profile", to_string(piece.profile)}});
    }
  }
  if (problem.elasticity().indenter()) json["elastic"] = solid(*problem.elasticity().indenter());
  return json;
}

/// The problem as read: exact, with defaults filled in.
Json problem_json(const Problem& read) {
  const ContactProblem& problem = read.contact;
  Json json;
  json["load"] = exact_text(problem.load());
  if (problem.load_at()) json["load_at"] = exact_text(*problem.load_at());
  json["sliding"] = name_of(problem.sliding());
  if (!read.units.length.empty()) json["units"]["length"] = read.units.length;
  if (!read.units.force.empty()) json["units"]["force"] = read.units.force;
  json["half_space"] = half_space(problem.elasticity(), problem.body());
  json["friction"] = {{"values", numbers(problem.friction().values())}, {"jumps", numbers(problem.friction().jumps())}};
  if (read.friction_file) json["friction"]["samples"] = *read.friction_file;
  json["indenter"] = indenter(problem, read.measured);
  return json;
}

Json end_json(const EndText& end) {
  return with(Json(), "x", end.x, "kind", end.kind, "exponent", decimal_json(end.exponent), "intensity", end.intensity);
}

Json singular_json(const SingularText& point) {
  const auto& [value, symbolic, latex] = point.exponent;
  return with(Json(), "x", point.x, "kind", point.kind, "exponent", decimal_json(value), "symbolic", symbolic, "latex",
              latex, "intensity", point.intensity, "constant", point.constant, "stress_intensity",
              point.stress_intensity, "stress_intensity_unit", point.unit);
}

Json component_json(const SolutionText& solution, std::size_t k) {
  const auto& [left, right] = solution.contact[k];
  return with(Json(), "left", end_json(left), "right", end_json(right), "width", solution.width[k], "load",
              solution.component_load[k]);
}

Json contact_json(const SolutionText& solution) {
  Json json = Json::array();
  for (std::size_t k = 0; k < solution.contact.size(); ++k) json.push_back(component_json(solution, k));
  return json;
}

Json json_of(std::size_t count) { return count; }
Json json_of(const ResultantsText::Largest& largest) {
  return with(Json(), "value", largest.value, "x", largest.x, "exponent", decimal_json(largest.exponent));
}
Json json_of(const answer::IntervalOf<NumberText>& interval) {
  return with(Json(), "left", interval.left, "right", interval.right);
}
template <class Value>
Json json_of(const std::optional<Value>& value) {
  return value ? json_of(*value) : Json();
}

/// Null if a solution has no quantity of this name.
Json resultant_json(const SolutionText& solution, std::string_view name) {
  Json json;
  answer::for_each_quantity(solution.resultants, [&](const answer::Quantity& row, const auto& value) {
    if (row.key == name) json = json_of(value);
  });
  return json;
}

Json resultants_json(const SolutionText& solution) {
  Json json;
  answer::for_each_quantity(solution.resultants, [&](const answer::Quantity& row, const auto& value) {
    if (Json one = json_of(value); !one.is_null()) json[std::string(row.key)] = std::move(one);
  });
  return json;
}

Json sample_json(const SampleText& sample) {
  Json json = with(Json(), "x", decimal_json(sample.x), "traction", sample.traction, "shear", sample.shear, "gap",
                   sample.gap, "slope", sample.slope, "u", sample.displacement, "shear_slope", sample.shear_slope,
                   "cumulative_load", sample.cumulative_load);
  const auto& [left, right] = sample.friction;
  json["friction"] = left == right ? text_json(left) : Json{{"left", left}, {"right", right}};
  return json;
}

Json largest_stress_json(const LargestStressText& largest) {
  Json json = with(Json(), "depth", decimal_json(largest.depth), "von_mises", largest.von_mises, "x", largest.x, "z",
                   largest.z, "unbounded_at", largest.unbounded_at);
  if (largest.proved) json["proved"] = "lower bound";
  if (const auto& average = largest.average) {
    json["average"] = with(Json(), "over", decimal_json(average->over), "von_mises", average->von_mises, "x",
                           average->x, "z", average->z);
  }
  return json;
}

void add_field(Json& json, const FieldText& field) {
  for (const FieldTable& table : field.tables) {
    json[table.key] = array(table.rows, [&](const auto& row) { return row_json(table.columns, row); });
  }
  for (std::size_t k = 0; k < field.gradients.size(); ++k) {
    const auto& [x_x, x_z, z_x, z_z] = field.gradients[k];
    json["stresses"][k]["displacement_gradient"] =
        with(Json(), "dux_dx", x_x, "dux_dz", x_z, "duz_dx", z_x, "duz_dz", z_z);
  }
  if (field.largest_stress) json["largest_stress"] = largest_stress_json(*field.largest_stress);
}

Json sizes_json(const std::vector<NamedSize>& sizes) {
  Json json;
  for (const auto& [name, size] : sizes) json[name] = decimal_json(size);
  return json;
}

Json proof_json(const ProofText& proof) {
  if (proof.proved) return {{"status", "proved"}, {"bits", proof.bits}, {"intervals", proof.intervals}};
  return {{"status", "not_proved"}, {"reason", proof.reason}, {"x", decimal_json(proof.x)}};
}

Json bound_json(const BoundText& bound) {
  if (!bound.proved) return {{"status", "not_proved"}, {"reason", bound.reason}};
  return {{"status", "proved"},
          {"cells", bound.cells},
          {"energy", decimal_json(bound.energy)},
          {"largest_gap", decimal_json(bound.largest_gap)}};
}

Json tolerance_json(const ToleranceText& tolerance) {
  Json json{{"profile", tolerance.profile}, {"friction", tolerance.friction}};
  json["status"] = tolerance.proved ? "proved" : "estimated";
  json["energy"] = decimal_json(tolerance.energy);
  json["load_share"] = array(tolerance.load_share, [](const IntervalText& share) { return json_of(share); });
  return with(std::move(json), "friction_force", tolerance.friction_force, "effective_friction",
              tolerance.effective_friction);
}

Json cells_json(const CellsText& cells) {
  return {{"count", cells.count}, {"from", decimal_json(cells.from.value)}, {"to", decimal_json(cells.to.value)}};
}

Json solution_json(const SolutionText& solution) {
  Json json;
  for (const char* key :
       {"method", "digits", "contact", "singular_points", "resultants", "samples", "estimated_error", "residuals"}) {
    json[key] = solution_entry(solution, key);
  }
  if (solution.cells) json["cells"] = cells_json(*solution.cells);
  add_field(json, solution.field);
  if (solution.proof) json["proof"] = proof_json(*solution.proof);
  if (solution.bound) json["bound"] = bound_json(*solution.bound);
  if (solution.tolerance) json["tolerance"] = tolerance_json(*solution.tolerance);
  return json;
}

Json uniqueness_json(const SolutionText& solution) {
  if (!solution.failed_condition.empty()) return {{"status", "not_solved"}, {"reason", solution.failed_condition}};
  if (solution.uniqueness.empty()) return {{"status", "not_decided"}, {"reason", no_uniqueness}};
  return {{"status", only_solution}, {"reason", solution.uniqueness}};
}

/// The beginning of every result.
Json heading(const Problem& problem) {
  return {{"schema", 2}, {"version", version}, {"problem", problem_json(problem)}};
}

/// The end of every result: failed condition, uniqueness and warnings.
Json finished(Json json, const SolutionText& solution) {
  json["failed_condition"] = text_json(solution.failed_condition);
  json["uniqueness"] = uniqueness_json(solution);
  json["warnings"] = solution.warnings;
  return json;
}

void write(const Json& json, Output& output) { output.write(json.dump(2) + "\n"); }

}  // namespace

Json solution_entry(const SolutionText& solution, std::string_view key) {
  if (key == "method") return solution.method;
  if (key == "digits") return solution.digits;
  if (key == "cells") return solution.cells ? cells_json(*solution.cells) : Json();
  if (key == "contact") return contact_json(solution);
  if (key == "singular_points") return array(solution.singular_points, singular_json);
  if (key == "resultants") return resultants_json(solution);
  if (key == "samples") return array(solution.samples, sample_json);
  if (key == "estimated_error") return sizes_json(solution.errors);
  if (key == "residuals") return sizes_json(solution.residuals);
  if (key == "largest_stress" && solution.field.largest_stress)
    return largest_stress_json(*solution.field.largest_stress);
  if (key == "uniqueness") return uniqueness_json(solution);
  if (key == "warnings") return solution.warnings;
  return {};
}

Json solution_entry(const SolutionText& solution, std::string_view key, const Step& next) {
  const auto* name = std::get_if<std::string>(&next);
  if (key == "resultants") return name != nullptr ? resultant_json(solution, *name) : Json();
  const auto one_of = [&](std::size_t size, auto json_of_one) -> Json {
    if (name != nullptr) return *name == "size" ? Json(size) : Json();
    const std::size_t index = std::get<std::size_t>(next);
    return index < size ? json_of_one(index) : Json();
  };
  if (key == "contact") {
    return one_of(solution.contact.size(), [&](std::size_t k) { return component_json(solution, k); });
  }
  if (key == "singular_points") {
    return one_of(solution.singular_points.size(),
                  [&](std::size_t k) { return singular_json(solution.singular_points[k]); });
  }
  const Json whole = solution_entry(solution, key);
  if (whole.is_array()) return one_of(whole.size(), [&](std::size_t k) { return whole[k]; });
  return name != nullptr && whole.is_object() && whole.contains(*name) ? whole[*name] : Json();
}

void write_json(const Problem& problem, const SolutionText& solution, Output& output) {
  Json json = heading(problem);
  json.update(solution_json(solution));
  write(finished(std::move(json), solution), output);
}

void write_json(const Problem& problem, const BothText& both, Output& output) {
  Json json = heading(problem);
  json.update(solution_json(both.as_given));
  json = finished(std::move(json), both.as_given);
  json["other_direction"] = {{"sliding", name_of(opposite(problem.contact.sliding()))}};
  json["other_direction"].update(finished(solution_json(both.opposite), both.opposite));
  write(json, output);
}

}  // namespace steadyslide::app
