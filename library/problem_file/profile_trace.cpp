#include "library/problem_file/profile_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "library/problem_file/polynomial_parser.hpp"
#include "library/problem_file/table_reader.hpp"
#include "library/text/number_format.hpp"

namespace steadyslide::library {
namespace {

/// The most bits of all coefficients together: about twice those of 10^6 points with 17 digits each.
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

class TraceParser {
 public:
  TraceParser(const std::string& name, const std::optional<Support>& support, const Heights& heights)
      : reader_(name, {"a trace", "x,psi", {"x", "psi"}, 2}), support_(support), heights_(heights) {}

  ProfileTrace parse(std::string_view text) {
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    pieces_.reserve(std::min(lines, max_trace_points));
    reader_.read(text, [this](std::vector<Rational>& row) { add(std::move(row[0]), heights_.factor * row[1]); });
    if (points_ < 2) {
      throw reader_.error("too few points", "a trace has at least 2", fmt::format("{} points", points_));
    }
    std::optional<Trend> trend;
    if (heights_.detrend != Detrend::none) {
      trend = sums_.trend(heights_.detrend);
      take_off(*trend);
    }
    return {points_, {first_, x_}, std::move(pieces_), std::move(trend)};
  }

 private:
  void add(Rational x, Rational psi) {
    if (points_ == max_trace_points) {
      throw reader_.error("too many points", fmt::format("a trace has at most {}", max_trace_points), "more");
    }
    if (heights_.detrend != Detrend::none) sums_.add(x, psi, heights_.detrend == Detrend::line);
    if (sums_.is_too_long()) {
      throw reader_.error("trace too complicated to detrend", "sums over its numbers are limited in digits", "more");
    }
    if (points_ == 0) {
      first_ = x;
    } else if (x <= x_) {
      throw reader_.error("x: not increasing", "x increases from line to line",
                          to_string(x) + " after " + to_string(x_));
    } else if (!support_ || (x > support_->left && x_ < support_->right)) {
      const Rational slope = (psi - psi_) / (x - x_);
      Rational height = psi - slope * x;
      count_bits(bits(x) + bits(slope) + bits(height));
      pieces_.push_back({support_ ? std::min(x, support_->right) : x, Polynomial({std::move(height), slope})});
    }
    x_ = std::move(x);
    psi_ = std::move(psi);
    ++points_;
  }

  void take_off(const Trend& trend) {
    const Polynomial line({trend.height, trend.slope});
    bits_ = 0;
    for (Indenter::Piece& piece : pieces_) {
      piece.profile = piece.profile - line;
      std::size_t length = bits(piece.to);
      for (const Rational& coefficient : piece.profile.coefficients()) length += bits(coefficient);
      count_bits(length);
    }
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
  std::size_t points_ = 0;
  std::size_t bits_ = 0;
  Rational first_, x_, psi_;
  std::vector<Indenter::Piece> pieces_;
};

}  // namespace

ProfileTrace parse_trace(std::string_view text, const std::string& name, const std::optional<Support>& support,
                         const Heights& heights) {
  return TraceParser(name, support, heights).parse(text);
}

}  // namespace steadyslide::library
