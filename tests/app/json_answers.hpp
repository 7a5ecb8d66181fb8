#pragma once
// The answers of the program in JSON.

#include <nlohmann/json.hpp>

#include "app/command_line.hpp"
#include "model/rational.hpp"

namespace steadyslide::testing {

using Json = nlohmann::ordered_json;

/// Returns the JSON of a run. Checks that it succeeds, with nothing on the standard error.
inline Json json_of(const Finished& finished) { return Json::parse(out_of(finished)); }

/// Runs `solve - ARGUMENTS --format json`.
inline Json solve(const std::string& problem, const Arguments& arguments = {}) {
  return json_of(run(problem, joined(arguments, {"--format", "json"})));
}

inline Json solve_example(const std::string& file, const Arguments& arguments = {}) {
  return json_of(run_example(file, joined(arguments, {"--format", "json"})));
}

inline std::string keys(const Json& object, const char* between = " ") {
  std::string result;
  for (const auto& [key, value] : object.items()) result += (result.empty() ? "" : between) + key;
  return result;
}

/// True for a number with its error: {"value", "error"} or {"mid", "rad"}.
inline bool is_number(const Json& json) { return json.is_object() && (json.contains("error") || json.contains("rad")); }

/// Returns the value of a number with an error; other JSON unchanged.
inline const Json& value_of(const Json& json) { return is_number(json) ? json.front() : json; }
inline std::string text_of(const Json& decimal) {
  return decimal.is_string() ? decimal.get<std::string>() : decimal.dump();
}
inline Rational number(const Json& json) { return parse_rational(text_of(value_of(json))); }
inline Rational error_of(const Json& number) { return parse_rational(text_of(number.back())); }

/// Sums `visit(a, b)` over the numbers of `json` that have an error and the numbers at the same places of `other`.
template <class Visit>
int sum_over_numbers(const Json& json, const Json& other, const Visit& visit) {
  if (is_number(json)) {
    CAPTURE(json.dump() + ", " + other.dump());
    return visit(json, other);
  }
  int sum = 0;
  if (json.is_array()) {
    REQUIRE(json.size() == other.size());
    for (std::size_t k = 0; k < json.size(); ++k) sum += sum_over_numbers(json[k], other[k], visit);
  }
  if (!json.is_object()) return sum;
  for (const auto& [key, value] : json.items()) {
    if (value.is_structured()) sum += sum_over_numbers(value, other.at(key), visit);
  }
  return sum;
}

inline double real(const Json& json) { return std::stod(text_of(value_of(json))); }
/// The number, or the limit from this side.
inline double real_on(const Json& json, const char* side) { return real(json.contains(side) ? json.at(side) : json); }

inline bool near(const Json& a, const Json& b, const char* tolerance) {
  return abs(number(a) - number(b)) <= parse_rational(tolerance);
}

}  // namespace steadyslide::testing
