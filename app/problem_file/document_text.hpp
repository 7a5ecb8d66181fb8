#pragma once
// A document's text made ready for the TOML library (3.3.0), which recurses as deep as dotted keys go, keeps a hundred
// bytes for every value, and runs into code that it declares unreachable where it looks for white space and finds a
// character beyond ASCII.

#include <string>
#include <string_view>

namespace steadyslide::app {

/// The same document in ASCII, line by line: characters beyond ASCII are escaped in strings and dropped from comments.
/// Throws Failure (exit code 2, "NAME:LINE: ...") for text that is not UTF-8, for such characters elsewhere, and for
/// documents nested so deep or with so many values that no problem file needs them.
std::string ready_for_parser(std::string_view text, const std::string& name);

}  // namespace steadyslide::app
