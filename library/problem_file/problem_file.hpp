#pragma once
// A problem file, TOML, as an exact contact problem. The rules and the messages of bad files are here.

#include <optional>
#include <string>
#include <string_view>

#include "library/problem_file/document.hpp"
#include "library/problem_file/profile_trace.hpp"
#include "model/contact_problem.hpp"

namespace steadyslide::library {

inline constexpr std::size_t max_friction_values = 90000;
inline constexpr std::size_t max_pieces = 50000;

/// The measured profile that a problem's pieces come from.
struct MeasuredProfile {
  std::string file;  ///< as the problem file names it
  std::size_t points;
  std::string x_unit{};       ///< m, mm, um or nm, the problem's unit of length; empty: not said
  std::string height_unit{};  ///< that heights were given in; empty: that of x
  bool flip = false;          ///< heights were given towards the body
  std::optional<Trend> trend{};
};

struct Problem {
  ContactProblem contact;
  std::string file;
  std::optional<MeasuredProfile> measured;
};

/// Reads a trace, too, if there are samples, relative to `name`. Throws InvalidFile.
Problem parse_problem(std::string_view text, const std::string& name);

/// The same of a document that is read already. `alike`: a problem with the same [indenter], whose profile is not read
/// again.
Problem problem_of(const Value& document, const std::string& name, const Problem* alike = nullptr);

/// Reads a file, or the standard input for "-". Throws InvalidFile, UnreadableFile.
Problem read_problem(const std::string& name);

/// A problem file whose load and friction do not matter and may be left out: 1, and no friction.
struct Punch {
  Problem problem;
  bool has_friction;
};
Punch read_punch(const std::string& name);

}  // namespace steadyslide::library
