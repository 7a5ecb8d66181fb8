#pragma once

#include <string>

namespace steadyslide::library {

/// Returns the bytes of a regular file, or of the standard input for "-" and "/dev/stdin". Other pipes and devices are
/// refused: they may never end. `kind` names the expected document in messages. Throws UnreadableFile; throws
/// InvalidFile for a pipe, for a device and for a file larger than 64 MiB. No read is interrupted by a signal: no
/// signal handler of the program returns.
std::string read_input(const std::string& name, const std::string& kind);

}  // namespace steadyslide::library
