#pragma once
// A measured profile: points (x, psi) in a text file, joined by straight lines. Everything is exact, as in a problem
// file; every error message names the trace and the line.
//
//   Each line is a point with two columns (table_reader.hpp). x increases strictly. Both are in the user's unit of
//   length; psi points away from the body.

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

/// The part that is subtracted from the heights.
enum class Detrend { none, mean, line };

/// The conversion of the second column: psi is `factor` times the column, minus the trend.
struct Heights {
  Rational factor = 1;
  Detrend detrend = Detrend::none;
};

/// The trend height + slope x: the mean of all heights of the file, or their line of least squares. It comes from exact
/// sums. Its numbers are exact up to 128 bits each; longer ones are rounded to 20 significant digits.
struct Trend {
  Detrend kind;
  Rational height;
  Rational slope;
};

struct ProfileTrace {
  std::size_t points;                   ///< number of points in the file
  Support range;                        ///< first and last x of the file
  std::vector<Indenter::Piece> pieces;  ///< one between each two neighbouring points, cut at the ends of the support
  std::optional<Trend> trend{};         ///< the trend that was subtracted
};

/// The range of the trace is the support if `support` is absent; otherwise the pieces are cut at the ends of the
/// support. The caller has to refuse a support that exceeds the range. Throws InvalidFile.
ProfileTrace parse_trace(std::string_view text, const std::string& name, const std::optional<Support>& support,
                         const Heights& heights = {});

}  // namespace steadyslide::library
