#pragma once
// Texts of others, made safe to print.

#include <string>
#include <string_view>

namespace steadyslide::library {

/// Safe to print on one line of a terminal: control characters and bytes that are not UTF-8 as \xNN, long words and
/// long lines shortened.
std::string one_line(std::string_view text);

/// The beginning of a text that somebody wrote, in quotes, as one_line shows it.
std::string excerpt(std::string_view text);

}  // namespace steadyslide::library
