#pragma once
// Numbers with an error in JSON: {"value", "error"} is an estimate, {"mid", "rad"} is proved. Unknown ones are null.

#include <nlohmann/json.hpp>
#include <string>

#include "library/text/number_format.hpp"

namespace steadyslide::app {

/// A text; null if it is empty.
nlohmann::ordered_json text_json(const std::string& text);

/// A number if a double has all digits of the text, which holds for 16 digits or fewer; otherwise the text.
nlohmann::ordered_json decimal_json(const std::string& text);

/// A number with its error.
nlohmann::ordered_json number_json(const library::NumberText& number);

}  // namespace steadyslide::app
