#pragma once

#include <string>

namespace steadyslide::library {

/// The bytes of a regular file, or of the standard input for "-" and "/dev/stdin": pipes and devices of another name may
/// never end. `kind` is what it is meant to be, for the message. Throws UnreadableFile, and InvalidFile for a pipe or
/// a device and when it is larger than 64 MiB. No read is interrupted: of the signals that the program handles, none returns.
std::string read_input(const std::string& name, const std::string& kind);

}  // namespace steadyslide::library
