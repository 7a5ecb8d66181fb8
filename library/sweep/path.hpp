#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace steadyslide::library {

/// A key of a table, or the index of an entry of an array.
using Step = std::variant<std::string, std::size_t>;

/// Returns the steps of "a[2].b": a, 2, b. Empty if the text is not a path.
std::vector<Step> steps_of(std::string_view path);

}  // namespace steadyslide::library
