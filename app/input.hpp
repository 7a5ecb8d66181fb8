#pragma once
// What a user hands to a command.

#include <string>

namespace steadyslide::app {

/// The bytes of a file, or of the standard input for "-". Throws Failure: exit code 3 when it cannot be read, 2 when it
/// is larger than 64 MiB.
std::string read_input(const std::string& name);

}  // namespace steadyslide::app
