#include "app/terminal/failure.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace steadyslide::app {

Failure bad_command_line(const std::string& what) { return {ExitCode::bad_input, "command line: " + what}; }

Failure bad_command_line(const std::string& what, const std::string& rule, std::string_view value) {
  return bad_command_line(what + "; " + rule + "; " + excerpt(value));
}

void warn(const std::string& file, const std::vector<std::string>& warnings) {
  for (const std::string& what : warnings) {
    fmt::print(stderr, "steadyslide: {}\n", one_line(file + ": warning: " + what));
  }
}

}  // namespace steadyslide::app
