#pragma once
// A measured profile: points (x, psi) in a text file, joined by straight lines. Everything is exact, as in a problem
// file; every complaint names the trace and the line.
//
//   One point a line, two columns (table_reader.hpp), x strictly increasing, both in the user's unit of length, psi away
//   from the body.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/indenter.hpp"

namespace steadyslide::library {

inline constexpr std::size_t max_trace_points = 1000000;

struct Support {
  Rational left;
  Rational right;
};

/// What is taken off the heights.
enum class Detrend { none, mean, line };

/// What the second column means: psi is `factor` times it, then without its trend.
struct Heights {
  Rational factor = 1;
  Detrend detrend = Detrend::none;
};

/// height + slope x, the mean of all heights of the file or their line of least squares: from exact sums, kept exactly
/// up to 128 bits a number, and otherwise rounded to 20 significant digits.
struct Trend {
  Detrend kind;
  Rational height;
  Rational slope;
};

struct ProfileTrace {
  std::size_t points;                   ///< in the file
  Support range;                        ///< first and last x in the file
  std::vector<Indenter::Piece> pieces;  ///< one for each two neighbours, as far as the support reaches
  std::optional<Trend> trend{};         ///< what was taken off
};

/// Without a support, the trace's own range is it; else the pieces are cut at its ends. A support beyond the range is
/// the caller's to refuse. Throws InvalidFile.
ProfileTrace parse_trace(std::string_view text, const std::string& name, const std::optional<Support>& support,
                         const Heights& heights = {});

}  // namespace steadyslide::library
