#pragma once
// Points from a text file: so many numbers a line, exact as in a problem file.
//
//   Columns are separated by a semicolon if the line has one, else by a comma if it has one, else by blanks or tabs. From #
//   on a line is a comment; the first line that is more than a comment is a header if it begins with something else than a
//   digit, a sign or a point. CRLF and a byte order mark are fine.

#include <string>
#include <string_view>
#include <vector>

#include "model/rational.hpp"

namespace steadyslide::app {

/// One row a line: a number for each of the columns' names. Throws Failure (exit code 2) "NAME:LINE: what is wrong; the rule;
/// the value", also where there are no rows or more than `most`.
std::vector<std::vector<Rational>> parse_points(std::string_view text, const std::string& name,
                                                const std::vector<std::string>& columns, std::size_t most);

/// The same of a file, or of the standard input for "-". Throws Failure (exit code 3) where it cannot be read.
std::vector<std::vector<Rational>> read_points(const std::string& name, const std::vector<std::string>& columns,
                                               std::size_t most);

}  // namespace steadyslide::app
