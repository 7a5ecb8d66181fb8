#pragma once
// Makes texts from outside safe to print.

#include <string>
#include <string_view>

namespace steadyslide::library {

/// Returns the text in a form that is safe on one line of a terminal: control characters and bytes that are not UTF-8
/// become \xNN, long words and long lines are shortened.
std::string one_line(std::string_view text);

/// Returns the beginning of a text from outside, in quotes, in the form of one_line().
std::string excerpt(std::string_view text);

}  // namespace steadyslide::library
