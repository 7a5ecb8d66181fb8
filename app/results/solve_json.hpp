#pragma once
// The JSON of `steadyslide solve`, entry by entry.

#include <nlohmann/json.hpp>
#include <string_view>

#include "app/results/solution_text.hpp"
#include "library/sweep/path.hpp"

namespace steadyslide::app {

/// What stands under this key of the result: "resultants", "contact", "warnings" ... Null for any other key.
nlohmann::ordered_json solution_entry(const SolutionText& solution, std::string_view key);

/// What the next step from there leads to, made alone; "size" of a list: how many. Null where it leads to nothing.
nlohmann::ordered_json solution_entry(const SolutionText& solution, std::string_view key, const Step& next);

}  // namespace steadyslide::app
