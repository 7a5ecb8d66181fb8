#pragma once
// What a system wants of a program beside the program, from the same list of commands as --help.

#include <string>

#include "app/commands/command_line.hpp"

namespace steadyslide::app {

/// A page for man(1), section 1.
std::string manual_page(const Program& program);

/// Completions for bash: commands, their options, the words that an option takes, and files.
std::string bash_completion(const Program& program);

}  // namespace steadyslide::app
