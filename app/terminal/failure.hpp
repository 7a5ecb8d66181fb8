#pragma once
// The end of a command: its exit code, and one line with the reason. Nothing below main() exits or prints an error. A
// warning is printed at the end of a command, by warn().

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "library/text/one_line.hpp"

namespace steadyslide::app {

using namespace library;  // the library's readers and texts

enum class ExitCode { done = 0, refuted = 1, bad_input = 2, failed = 3, interrupted = 130 };

/// The failure of a command. what() is the line for stderr, without the program's name.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}

  ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

/// Returns the failure "command line: WHAT" with exit code 2.
Failure bad_command_line(const std::string& what);
/// Returns the failure "command line: WHAT; RULE; VALUE" with exit code 2.
Failure bad_command_line(const std::string& what, const std::string& rule, std::string_view value);

/// Writes "steadyslide: MESSAGE" to stderr, on one line. If stderr cannot be written, nothing happens.
void print_message(const std::string& message);

/// Writes "steadyslide: FILE: warning: WHAT" to stderr, one line for each warning.
void warn(const std::string& file, const std::vector<std::string>& warnings);

}  // namespace steadyslide::app
