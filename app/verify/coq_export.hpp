#pragma once
// `steadyslide verify --export-coq DIR`: what the symbolic layer decides, for a kernel that is not ours (docs/coq.md).

#include <string>

namespace steadyslide::app {

/// Writes a file for each family of statements into a folder that is new or empty, all of them or none. Returns how many
/// lemmas they hold, and which equations are not exported, and why. Throws Failure.
std::string export_coq(const std::string& folder);

}  // namespace steadyslide::app
