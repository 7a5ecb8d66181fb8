#pragma once
// Numbers with an error in JSON: {"value", "error"}, an estimate; {"mid", "rad"}, proved. All are texts, null where not known.

#include <nlohmann/json.hpp>
#include <string>

#include "library/text/number_format.hpp"

namespace steadyslide::app {

/// The shapes of a JSON document that --schema asks for (docs/output.md).
enum class Schema { one = 1, two = 2 };

/// A text; null where it is empty.
nlohmann::ordered_json text_json(const std::string& text);

/// A number with its error.
nlohmann::ordered_json number_json(const library::NumberText& number);

/// A document, or a part of one, as schema 1 has it: KEY and KEY_error in the place of each number, of each pair of limits
/// and each list of numbers; the friction force as "tangential", too; no failed condition.
nlohmann::ordered_json in_schema_1(const nlohmann::ordered_json& json);

}  // namespace steadyslide::app
