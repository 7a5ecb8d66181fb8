#pragma once
// The lists of a command line: "0.1,0.2" or "0:0.4:0.1" (first, last, step; inclusive, exact).

#include <string>
#include <string_view>
#include <vector>

#include "model/rational.hpp"

namespace steadyslide::app {

/// Throws Failure (command line) that names `option`, also when there are more than `most` entries.
std::vector<Rational> parse_list(const std::string& option, std::string_view text, std::size_t most);

/// A whole number from `least` to `most`. Throws Failure (command line) that names `option`.
int parse_count(const std::string& option, std::string_view text, int least, int most);

}  // namespace steadyslide::app
