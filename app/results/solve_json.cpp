#include <nlohmann/json.hpp>

#include "app/results/number_format.hpp"
#include "app/results/solve_writers.hpp"
#include "app/version.hpp"

namespace steadyslide::app {
namespace {

using Json = nlohmann::ordered_json;

/// A number's text; null where there is no number.
Json number(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json numbers(const std::vector<Rational>& values) {
  Json list = Json::array();
  for (const Rational& value : values) list.push_back(exact_text(value));
  return list;
}

/// KEY and KEY_error.
void add(Json& json, const std::string& key, const NumberText& text) {
  json[key] = number(text.value);
  json[key + "_error"] = number(text.error);
}

void add(Json& json, const std::string& key, const LimitText& limits) {
  if (!limits.two_sided()) return add(json, key, limits.left);
  json[key] = {{"left", number(limits.left.value)}, {"right", number(limits.right.value)}};
  json[key + "_error"] = {{"left", number(limits.left.error)}, {"right", number(limits.right.error)}};
}

void add(Json& json, const std::string& key, const std::vector<NumberText>& list) {
  json[key] = Json::array();
  json[key + "_error"] = Json::array();
  for (const NumberText& text : list) {
    json[key].push_back(number(text.value));
    json[key + "_error"].push_back(number(text.error));
  }
}

Json solid(const Solid& body) { return {{"poisson", exact_text(body.poisson())}, {"young", exact_text(body.young())}}; }

Json half_space(const Elasticity& elasticity) {
  if (!elasticity.half_space()) return {{"gamma", exact_text(elasticity.gamma())}};
  Json json = solid(*elasticity.half_space());
  json["plane"] = elasticity.plane() == Plane::strain ? "strain" : "stress";
  return json;
}

Json indenter(const ContactProblem& problem, const std::optional<Samples>& samples) {
  const Indenter& shape = problem.indenter();
  Json json{{"support", numbers({shape.left(), shape.right()})}};
  if (samples) {
    // The trace is named: its pieces can be many more than the results.
    json["samples"] = samples->file;
    json["points"] = samples->points;
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

/// The problem as read, exact, defaults filled in.
Json problem_json(const ContactProblem& problem, const std::optional<Samples>& samples) {
  Json json;
  json["load"] = exact_text(problem.load());
  if (problem.load_at()) json["load_at"] = exact_text(*problem.load_at());
  json["sliding"] = problem.sliding() == Sliding::plus_x ? "+x" : "-x";
  json["half_space"] = half_space(problem.elasticity());
  json["friction"] = {{"values", numbers(problem.friction().values())}, {"jumps", numbers(problem.friction().jumps())}};
  json["indenter"] = indenter(problem, samples);
  return json;
}

Json end_json(const EndText& end) {
  Json json;
  add(json, "x", end.x);
  json["kind"] = end.kind;
  json["exponent"] = number(end.exponent);
  add(json, "intensity", end.intensity);
  return json;
}

Json singular_json(const SingularText& point) {
  Json json;
  add(json, "x", point.x);
  json["kind"] = point.kind;
  json["exponent"] = point.exponent.value;
  json["symbolic"] = point.exponent.symbolic;
  json["latex"] = point.exponent.latex;
  add(json, "intensity", point.intensity);
  add(json, "constant", point.constant);
  return json;
}

Json resultants_json(const SolveReport& report) {
  Json json;
  add(json, "normal", report.normal);
  add(json, "tangential", report.tangential);
  add(json, "centre_of_pressure", report.centre_of_pressure);
  add(json, "effective_friction", report.effective_friction);
  add(json, "load_share", report.load_share);
  if (report.tilt) add(json, "tilt", *report.tilt);
  return json;
}

Json sample_json(const SampleText& sample) {
  Json json;
  json["x"] = number(sample.x);
  add(json, "traction", sample.traction);
  add(json, "shear", sample.shear);
  add(json, "gap", sample.gap.value_or(NumberText{}));
  add(json, "slope", sample.slope);
  return json;
}

Json solution_json(const SolveReport& report) {
  Json json;
  json["method"] = report.method;
  json["digits"] = report.digits;
  json["contact"] = Json::array();
  for (const auto& [left, right] : report.contact) {
    json["contact"].push_back({{"left", end_json(left)}, {"right", end_json(right)}});
  }
  json["singular_points"] = Json::array();
  for (const SingularText& point : report.singular_points) json["singular_points"].push_back(singular_json(point));
  json["resultants"] = resultants_json(report);
  json["samples"] = Json::array();
  for (const SampleText& sample : report.samples) json["samples"].push_back(sample_json(sample));
  json["estimated_error"] = {{"ends", number(report.error_ends)},
                             {"traction", number(report.error_traction)},
                             {"resultants", number(report.error_resultants)}};
  json["residuals"] = {{"equation", number(report.residual_equation)},
                       {"load", number(report.residual_load)},
                       {"penetration", number(report.residual_penetration)},
                       {"tension", number(report.residual_tension)}};
  return json;
}

Json uniqueness_json(const Uniqueness& uniqueness, const std::string& shortcoming) {
  if (!shortcoming.empty()) return {{"status", "not_solved"}, {"reason", shortcoming}};
  return {{"status", uniqueness.proved ? unique_by_theorem : "not_covered"}, {"reason", uniqueness.reason}};
}

/// What opens every result.
Json heading(const Problem& problem) {
  return {{"schema", 1}, {"version", version}, {"problem", problem_json(problem.contact, problem.samples)}};
}

/// A solution of a search: it has no samples.
Json found_json(const SolveReport& report) {
  Json json = solution_json(report);
  json.erase("samples");
  return json;
}

}  // namespace

void write_solve_json(const Problem& problem, const SolveReport& report, Output& output) {
  Json json = heading(problem);
  json.update(solution_json(report));
  json["uniqueness"] = uniqueness_json(report.uniqueness, report.shortcoming);
  json["warnings"] = report.warnings;
  output.write(json.dump(2) + "\n");
}

void write_search_json(const Problem& problem, const SearchReport& report, Output& output) {
  Json json = heading(problem);
  json["search"] = {{"starts", report.starts},
                    {"unsolved", report.unsolved},
                    {"agreed", report.agreed()},
                    {"different_refinements", report.refinements}};
  json["solutions"] = Json::array();
  for (const FoundReport& found : report.solutions) {
    json["solutions"].push_back({{"times", found.times},
                                 {"variational", found_json(found.variational)},
                                 {"refined", found.refined ? found_json(*found.refined) : Json()}});
  }
  json["uniqueness"] = uniqueness_json(report.uniqueness, report.shortcoming);
  json["warnings"] = report.warnings;
  output.write(json.dump(2) + "\n");
}

}  // namespace steadyslide::app
