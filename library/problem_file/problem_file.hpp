#pragma once
// Reads a problem file (TOML) as an exact contact problem. The rules of the format and the messages for bad files are
// here.

#include <optional>
#include <string>
#include <string_view>

#include "library/problem_file/document.hpp"
#include "library/problem_file/friction_table.hpp"
#include "library/problem_file/indenter_reader.hpp"
#include "model/contact_problem.hpp"
#include "model/wear.hpp"

namespace steadyslide::library {

/// Names of units, for the axes of pictures. Nothing is converted. Empty: the user's unit.
struct Units {
  std::string length;
  std::string force;
};

struct Problem {
  ContactProblem contact;
  std::string file;
  std::optional<MeasuredProfile> measured;
  std::optional<std::string> friction_file{};  ///< the friction table, as the problem file writes its name
  Units units{};  ///< without `units.length`, the length is that of `indenter.samples.x_unit`
  std::optional<Wear> wear{};
};

/// Reads a trace and a friction table, too, if the file has samples; their paths are relative to `name`. Throws InvalidFile.
Problem parse_problem(std::string_view text, const std::string& name);

/// The same for a document that is already parsed. `same_indenter`: null, or a problem with the same [indenter]
/// table; then its profile is used and not read again.
Problem problem_of(const Value& document, const std::string& name, const Problem* same_indenter = nullptr);

/// Reads a file, or the standard input for "-". Throws InvalidFile and UnreadableFile.
Problem read_problem(const std::string& name);

/// A problem file that needs neither load nor friction. If they are absent, the load is 1 and there is no friction.
struct Punch {
  Problem problem;
  bool has_friction;
};
Punch read_punch(const std::string& name);

}  // namespace steadyslide::library
