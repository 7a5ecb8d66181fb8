#pragma once
// A measured profile: points (x, psi) in a text file, joined by straight lines or by a cubic spline (smoothing.hpp).
// Everything is exact, as in a problem file, except filtered heights and the slopes of a spline: they are rounded to
// double. Every error message names the trace and the line.
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

enum class Interpolation { linear, spline };

/// The way from the second column to the profile: the heights are `factor` times the column, minus the trend, then
/// filtered, then joined.
struct Heights {
  Rational factor = 1;
  Detrend detrend = Detrend::none;
  std::optional<Rational> cutoff{};  ///< of the Gaussian filter, > 0; absent: no filter
  Interpolation interpolation = Interpolation::linear;
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

/// `name` as in table_reader.hpp. The range of the trace is the support if `support` is absent; otherwise the pieces are cut at the ends of the
/// support. The caller has to refuse a support that exceeds the range. The pieces of a spline have cubic polynomials
/// with exact coefficients, with the same values and slopes where they meet. Throws InvalidFile, and InvalidData with
/// the field "filter.cutoff" if the cutoff does not fit the points.
ProfileTrace parse_trace(std::string_view text, const std::string& name, const std::optional<Support>& support,
                         const Heights& heights = {});

}  // namespace steadyslide::library
