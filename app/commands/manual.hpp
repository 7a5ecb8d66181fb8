#pragma once
// The manual page and the bash completions of a program, made from the same list of commands as --help.

#include <string>

#include "app/commands/command_line.hpp"

namespace steadyslide::app {

/// Returns a page for man(1), section 1.
std::string manual_page(const Program& program);

/// Returns completions for bash: commands, their options, the words that an option allows, and files.
std::string bash_completion(const Program& program);

}  // namespace steadyslide::app
