#pragma once
// The JSON of `steadyslide solve`, entry by entry.

#include <nlohmann/json.hpp>
#include <string_view>

#include "app/results/solution_text.hpp"
#include "library/sweep/path.hpp"

namespace steadyslide::app {

/// Returns the value of this key of the result: "resultants", "contact", "warnings" ... Null for any other key.
nlohmann::ordered_json solution_entry(const SolutionText& solution, std::string_view key);

/// Returns only the part of that value to which the next step leads; "size" is the length of a list. Null if the step
/// leads nowhere.
nlohmann::ordered_json solution_entry(const SolutionText& solution, std::string_view key, const Step& next);

}  // namespace steadyslide::app
