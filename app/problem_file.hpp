#pragma once
// A problem file, TOML, as an exact contact problem. The rules and the messages of bad files are here.

#include <string>
#include <string_view>

#include "model/contact_problem.hpp"

namespace steadyslide::app {

inline constexpr std::size_t max_friction_values = 10000;
inline constexpr std::size_t max_pieces = 1000;

struct Problem {
  ContactProblem contact;
  std::string file;
};

/// Throws Failure (exit code 2) "NAME:LINE: what is wrong; the rule; the value".
Problem parse_problem(std::string_view text, const std::string& name);

/// Reads a file, or the standard input for "-". Throws Failure.
Problem read_problem(const std::string& name);

}  // namespace steadyslide::app
