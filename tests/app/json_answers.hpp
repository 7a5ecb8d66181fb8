#pragma once
// The program's answers in JSON.

#include <nlohmann/json.hpp>

#include "app/command_line.hpp"
#include "model/rational.hpp"

namespace steadyslide::testing {

using Json = nlohmann::ordered_json;

/// Of a run that succeeds without a word.
inline Json json_of(const Finished& finished) { return Json::parse(out_of(finished)); }

/// `solve - ARGUMENTS --format json`
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

inline Rational number(const Json& text) { return parse_rational(text.get<std::string>()); }

inline bool near(const Json& a, const Json& b, const char* tolerance) {
  return abs(number(a) - number(b)) <= parse_rational(tolerance);
}

}  // namespace steadyslide::testing
