#include "app/terminal/failure.hpp"

#include <cstdio>

namespace steadyslide::app {

Failure bad_command_line(const std::string& what) { return {ExitCode::bad_input, "command line: " + what}; }

Failure bad_command_line(const std::string& what, const std::string& rule, std::string_view value) {
  return bad_command_line(what + "; " + rule + "; " + excerpt(value));
}

void print_message(const std::string& message) {
  // fmt::print would throw here.
  std::fputs(("steadyslide: " + one_line(message) + "\n").c_str(), stderr);
}

void warn(const std::string& file, const std::vector<std::string>& warnings) {
  for (const std::string& what : warnings) print_message(file + ": warning: " + what);
}

}  // namespace steadyslide::app
