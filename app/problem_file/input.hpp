#pragma once
// What a user hands to a command.

#include <string>

namespace steadyslide::app {

/// The bytes of a file, or of the standard input for "-". `kind` is what it is meant to be, for the message. Throws
/// Failure: exit code 3 when it cannot be read, 2 when it is larger than 64 MiB.
std::string read_input(const std::string& name, const std::string& kind = "a problem file");

}  // namespace steadyslide::app
