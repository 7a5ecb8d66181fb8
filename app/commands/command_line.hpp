#pragma once
// The command line: what each command takes, its help, and which command is meant.

#include <string>
#include <variant>

#include "app/commands/options.hpp"

namespace steadyslide::app {

/// Text to print instead of doing anything: --help, --version.
struct Message {
  std::string text;
};

using Command =
    std::variant<Message, VerifyOptions, ExponentsOptions, TableOptions, SolveOptions, FiguresOptions, ReportOptions>;

/// Throws Failure (exit code 2) "command line: ...".
Command parse_command_line(int argc, const char* const* argv);

}  // namespace steadyslide::app
