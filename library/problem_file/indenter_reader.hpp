#pragma once
// The table [indenter] of a problem file.

#include <optional>
#include <string>

#include "library/problem_file/problem_reader.hpp"
#include "library/problem_file/profile_trace.hpp"

namespace steadyslide::library {

inline constexpr std::size_t max_pieces = 50000, max_harmonics = 100;

/// The measured profile from which the pieces of a problem were made.
struct MeasuredProfile {
  std::string file;  ///< as the problem file writes it; empty if the problem file has the points themselves
  std::size_t points;
  std::string x_unit{};       ///< m, mm, um or nm, the problem's unit of length; empty if absent
  std::string height_unit{};  ///< the unit of the heights in the file; empty: that of x
  bool flip = false;          ///< true if heights are given towards the body
  std::optional<Trend> trend{};
  std::optional<Rational> cutoff{};  ///< of the Gaussian filter, in the problem's unit of length; absent: no filter
  Interpolation interpolation = Interpolation::linear;
};

struct ReadIndenter {
  Indenter shape;
  std::optional<MeasuredProfile> measured;
};

/// Reads the support, and the profile as a polynomial, as pieces, as harmonics or as a measured trace. `file` is the problem file's
/// name; a trace is looked for in its folder. Throws InvalidFile.
ReadIndenter read_indenter(const ProblemReader& reader, const std::string& file);

}  // namespace steadyslide::library
