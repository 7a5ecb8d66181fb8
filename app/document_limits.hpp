#pragma once
// A look at a document before it is parsed: the TOML library recurses as deep as dotted keys go, and keeps a hundred
// bytes for every value.

#include <string>
#include <string_view>

namespace steadyslide::app {

/// Throws Failure (exit code 2, "NAME:LINE: ...").
void check_document_limits(std::string_view text, const std::string& name);

}  // namespace steadyslide::app
