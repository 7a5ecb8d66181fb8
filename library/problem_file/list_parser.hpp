#pragma once
// Lists of numbers as one text: "0.1,0.2" or "0:0.4:0.1" (first, last, step; inclusive, exact).

#include <string_view>
#include <vector>

#include "model/rational.hpp"

namespace steadyslide::library {

/// Throws InvalidData (field empty), also if there are more than `most` entries.
std::vector<Rational> parse_list(std::string_view text, std::size_t most);

/// Returns a whole number from `least` to `most`. Throws InvalidData (field empty).
int parse_count(std::string_view text, int least, int most);

}  // namespace steadyslide::library
