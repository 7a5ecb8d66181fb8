#include "library/problem_file/profile_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "library/problem_file/polynomial_parser.hpp"
#include "library/problem_file/smoothing.hpp"
#include "library/problem_file/table_reader.hpp"
#include "library/text/number_format.hpp"
#include "model/invalid_data.hpp"
#include "numeric/number/real.hpp"

namespace steadyslide::library {
namespace {

/// The most bits of all points, and of all coefficients, together: about twice those of 10^6 points with 17 digits each.
constexpr std::size_t most_bits = 1000000000;
/// The most bits of one sum over a trace. A sum of numbers without a common denominator grows with every point.
constexpr std::size_t most_sum_bits = 10000;
/// The numbers of a trend are kept exactly up to this many bits. Longer ones are rounded to `trend_digits` digits.
constexpr std::size_t most_trend_bits = 128;
constexpr int trend_digits = 20;

Rational of_trend(const Rational& value) {
  return bits(value) <= most_trend_bits ? value : parse_rational(full_number(value, trend_digits));
}

/// Sums over points: for the mean of the heights, or for the line of least squares.
class TrendSums {
 public:
  void add(const Rational& x, const Rational& y, bool with_line) {
    ++count_;
    y_ += y;
    if (!with_line) return;
    x_ += x;
    xx_ += x * x;
    xy_ += x * y;
  }

  bool is_too_long() const { return std::max({bits(y_), bits(xx_), bits(xy_)}) > most_sum_bits; }

  /// The line needs at least two different x.
  Trend trend(Detrend kind) const {
    if (kind == Detrend::mean) return {kind, of_trend(y_ / count_), 0};
    const Rational slope = of_trend((count_ * xy_ - x_ * y_) / (count_ * xx_ - x_ * x_));
    return {kind, of_trend((y_ - slope * x_) / count_), slope};
  }

 private:
  Rational count_, x_, y_, xx_, xy_;
};

struct TracePoint {
  Rational x;
  Rational height;
};

class TraceParser {
 public:
  TraceParser(const std::string& name, const std::optional<Support>& support, const Heights& heights)
      : reader_(name, {"a trace", "x,psi", {"x", "psi"}, 2}), support_(support), heights_(heights) {}

  ProfileTrace parse(std::string_view text) {
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    points_.reserve(std::min(lines, max_trace_points));
    reader_.read(text, [this](std::vector<Rational>& row) { add(std::move(row[0]), heights_.factor * row[1]); });
    if (points_.size() < 2) {
      throw reader_.error("too few points", "a trace has at least 2", fmt::format("{} points", points_.size()));
    }
    std::optional<Trend> trend;
    if (heights_.detrend != Detrend::none) {
      trend = sums_.trend(heights_.detrend);
      for (TracePoint& point : points_) point.height -= trend->height + trend->slope * point.x;
    }
    if (heights_.cutoff) filter(*heights_.cutoff);
    return {points_.size(), {points_.front().x, points_.back().x}, pieces(), std::move(trend)};
  }

 private:
  void add(Rational x, Rational height) {
    if (points_.size() == max_trace_points) {
      throw reader_.error("too many points", fmt::format("a trace has at most {}", max_trace_points), "more");
    }
    if (heights_.detrend != Detrend::none) sums_.add(x, height, heights_.detrend == Detrend::line);
    if (sums_.is_too_long()) {
      throw reader_.error("trace too complicated to detrend", "sums over its numbers are limited in digits", "more");
    }
    if (!points_.empty() && x <= points_.back().x) {
      throw reader_.error("x: not increasing", "x increases from line to line",
                          to_string(x) + " after " + to_string(points_.back().x));
    }
    count_bits(bits(x) + bits(height));
    points_.push_back({std::move(x), std::move(height)});
  }

  void filter(const Rational& cutoff) {
    Rational longest = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) longest = std::max(longest, distance(i));
    const Rational whole = points_.back().x - points_.front().x;
    const auto refuse = [&](bool applies, const char* what, const char* rule, const Rational& limit) {
      if (!applies) return;
      throw InvalidData("filter.cutoff", what, fmt::format("{}, {}", rule, to_string(limit)), to_string(cutoff));
    };
    refuse(cutoff > whole, "cutoff longer than the trace", "it is at most the length of the trace", whole);
    refuse(cutoff < 2 * longest, "cutoff too short", "it is at least twice the longest distance between points",
           2 * longest);
    std::vector<double> x, heights;
    for (const TracePoint& point : points_) {
      x.push_back(in_double(point.x - points_.front().x));
      heights.push_back(in_double(point.height));
    }
    heights = gauss_filtered(x, heights, in_double(cutoff));
    for (std::size_t i = 0; i < points_.size(); ++i) points_[i].height = Rational(finite(heights[i]));
  }

  std::vector<Indenter::Piece> pieces() {
    const bool is_spline = heights_.interpolation == Interpolation::spline && points_.size() > 2;
    const std::vector<double> slopes = is_spline ? slopes_of_spline() : std::vector<double>();
    std::vector<Indenter::Piece> result;
    result.reserve(points_.size() - 1);
    bits_ = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const Rational& x = points_[i].x;
      if (support_ && (x <= support_->left || points_[i - 1].x >= support_->right)) continue;
      const Polynomial profile = is_spline ? cubic(i, Rational(slopes[i - 1]), Rational(slopes[i]))
                                           : Polynomial({points_[i].height - line(i) * x, line(i)});
      std::size_t length = bits(x);
      for (const Rational& coefficient : profile.coefficients()) length += bits(coefficient);
      count_bits(length);
      result.push_back({support_ ? std::min(x, support_->right) : x, profile});
    }
    return result;
  }

  std::vector<double> slopes_of_spline() const {
    std::vector<double> distances, lines;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      distances.push_back(in_double(distance(i)));
      if (!std::isnormal(distances.back())) throw out_of_range();
      lines.push_back(in_double(line(i)));
    }
    std::vector<double> slopes = spline_slopes(distances, lines);
    std::for_each(slopes.begin(), slopes.end(), [this](double slope) { finite(slope); });
    return slopes;
  }

  /// Returns the cubic polynomial between the points i - 1 and i with these slopes at its ends.
  Polynomial cubic(std::size_t i, const Rational& left, const Rational& right) const {
    const Rational h = distance(i);
    const Rational bend = (left + right - 2 * line(i)) / h;
    const Polynomial local({points_[i - 1].height, left, (line(i) - left) / h - bend, bend / h});
    return local.composed(1, -points_[i - 1].x);
  }

  Rational distance(std::size_t i) const { return points_[i].x - points_[i - 1].x; }
  /// Returns the slope of the straight line between the points i - 1 and i.
  Rational line(std::size_t i) const { return (points_[i].height - points_[i - 1].height) / distance(i); }

  double in_double(const Rational& value) const { return finite(numeric::to_real<double>(value)); }
  double finite(double value) const {
    if (!std::isfinite(value)) throw out_of_range();
    return value;
  }
  InvalidFile out_of_range() const {
    return reader_.error("numbers out of range", "a filter and a spline are computed in double", "beyond it");
  }

  void count_bits(std::size_t more) {
    bits_ += more;
    if (bits_ <= most_bits) return;
    throw reader_.error("trace too complicated", "all numbers together are limited in digits", "more");
  }

  TableReader reader_;
  const std::optional<Support>& support_;
  const Heights& heights_;
  TrendSums sums_;
  std::vector<TracePoint> points_;
  std::size_t bits_ = 0;
};

}  // namespace

ProfileTrace parse_trace(std::string_view text, const std::string& name, const std::optional<Support>& support,
                         const Heights& heights) {
  return TraceParser(name, support, heights).parse(text);
}

}  // namespace steadyslide::library
