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

Json limits(const LimitText& text) {
  if (!text.two_sided()) return number(text.left);
  return {{"left", number(text.left)}, {"right", number(text.right)}};
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
  return {{"x", number(end.x)},
          {"kind", end.kind},
          {"exponent", number(end.exponent)},
          {"intensity", number(end.intensity)}};
}

Json singular_json(const SingularText& point) {
  return {{"x", number(point.x)},
          {"kind", point.kind},
          {"exponent", point.exponent.value},
          {"symbolic", point.exponent.symbolic},
          {"latex", point.exponent.latex},
          {"intensity", number(point.intensity)},
          {"constant", number(point.constant)}};
}

Json resultants_json(const SolveReport& report) {
  Json shares = Json::array();
  for (const std::string& share : report.load_share) shares.push_back(number(share));
  Json json{{"normal", number(report.normal)},
            {"tangential", number(report.tangential)},
            {"centre_of_pressure", number(report.centre_of_pressure)},
            {"effective_friction", number(report.effective_friction)},
            {"load_share", std::move(shares)}};
  if (report.tilt) json["tilt"] = number(*report.tilt);
  return json;
}

Json sample_json(const SampleText& sample) {
  return {{"x", number(sample.x)},
          {"traction", limits(sample.traction)},
          {"shear", limits(sample.shear)},
          {"gap", sample.gap ? number(*sample.gap) : Json()},
          {"slope", limits(sample.slope)}};
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

Json uniqueness_json(const Uniqueness& uniqueness) {
  return {{"status", uniqueness.proved ? "proved" : "not_covered"}, {"reason", uniqueness.reason}};
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
  json["uniqueness"] = uniqueness_json(report.uniqueness);
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
  json["uniqueness"] = uniqueness_json(report.uniqueness);
  output.write(json.dump(2) + "\n");
}

}  // namespace steadyslide::app
