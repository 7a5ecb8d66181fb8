#pragma once
// Reads a problem file (TOML) as an exact contact problem. The rules of the format and the messages for bad files are
// here.

#include <optional>
#include <string>
#include <string_view>

#include "library/problem_file/document.hpp"
#include "library/problem_file/profile_trace.hpp"
#include "model/contact_problem.hpp"

namespace steadyslide::library {

inline constexpr std::size_t max_friction_values = 90000;
inline constexpr std::size_t max_pieces = 50000;

/// The measured profile from which the pieces of a problem were made.
struct MeasuredProfile {
  std::string file;  ///< as the problem file writes it
  std::size_t points;
  std::string x_unit{};       ///< m, mm, um or nm, the problem's unit of length; empty if absent
  std::string height_unit{};  ///< the unit of the heights in the file; empty: that of x
  bool flip = false;          ///< true if heights are given towards the body
  std::optional<Trend> trend{};
};

struct Problem {
  ContactProblem contact;
  std::string file;
  std::optional<MeasuredProfile> measured;
};

/// Reads a trace, too, if the file has samples; its path is relative to `name`. Throws InvalidFile.
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
