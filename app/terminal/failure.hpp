#pragma once
// How a command ends, and the one line that says why. Nothing below main() exits or prints an error; a warning is
// printed where a command ends, by warn().

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::app {

enum class ExitCode { done = 0, refuted = 1, bad_input = 2, failed = 3, interrupted = 130 };

/// The end of a command. what() is the line for stderr, without the program's name.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}

  ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

/// "command line: WHAT", exit code 2.
Failure bad_command_line(const std::string& what);
/// "command line: WHAT; RULE; VALUE", exit code 2.
Failure bad_command_line(const std::string& what, const std::string& rule, std::string_view value);

/// "steadyslide: FILE: warning: WHAT" on stderr, each on one line.
void warn(const std::string& file, const std::vector<std::string>& warnings);

/// Safe to print on one line of a terminal: control characters and bytes that are not UTF-8 as \xNN, long words and
/// long lines shortened.
std::string one_line(std::string_view text);

/// The beginning of a text that somebody wrote, in quotes, as one_line shows it.
std::string excerpt(std::string_view text);

}  // namespace steadyslide::app
