#include "app/results/number_json.hpp"

#include <algorithm>

namespace steadyslide::app {
namespace {

using Json = nlohmann::ordered_json;

bool is_number(const Json& json) { return json.contains("error") || json.contains("rad"); }

/// A number, a list of numbers, or their limits from both sides?
bool is_of_numbers(const std::string& key, const Json& json) {
  if (is_number(json)) return true;
  // Of lists that may be empty these are of numbers.
  if (json.empty()) return key == "load_share" || key == "unbounded_at" || key == "jumps";
  const bool is_pair = json.is_object() && json.size() == 2 && json.contains("left");
  return (is_pair || json.is_array()) && std::ranges::all_of(json, is_number);
}

/// Of the same shape: the values, which come first in a number, or the errors.
Json part(const Json& json, bool errors) {
  if (is_number(json)) return errors ? json.back() : json.front();
  Json result = json;
  for (Json& number : result) number = part(number, errors);
  return result;
}

}  // namespace

Json text_json(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json number_json(const library::NumberText& number) {
  return {{number.proved ? "mid" : "value", text_json(number.value)},
          {number.proved ? "rad" : "error", text_json(number.error)}};
}

Json in_schema_1(const Json& json) {
  if (!json.is_structured()) return json;
  Json result = json.is_array() ? Json::array() : Json::object();
  if (json.is_array()) {
    for (const Json& item : json) result.push_back(in_schema_1(item));
    return result;
  }
  const auto add = [&](const std::string& key, const Json& numbers) {
    result[key] = part(numbers, false);
    result[key + "_error"] = part(numbers, true);
  };
  for (const auto& [key, value] : json.items()) {
    if (key == "failed_condition") continue;
    if (key == "friction_force") add("tangential", value);
    if (key == "schema") {
      result[key] = 1;
    } else if (key == "problem") {
      result[key] = value;  // exact
    } else if (is_of_numbers(key, value)) {
      add(key, value);
    } else {
      result[key] = in_schema_1(value);
    }
  }
  return result;
}

}  // namespace steadyslide::app
