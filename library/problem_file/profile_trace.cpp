#include "library/problem_file/profile_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "library/problem_file/file_error.hpp"
#include "library/problem_file/polynomial_parser.hpp"
#include "library/text/number_format.hpp"
#include "library/text/one_line.hpp"
#include "model/invalid_data.hpp"

namespace steadyslide::library {
namespace {

constexpr std::size_t longest_trace_line = 1000;
/// Bits of all coefficients together: about twice those of 10^6 points with 17 digits each.
constexpr std::size_t most_bits = 1000000000;
/// Of one sum over a trace: numbers without a common denominator let it grow with every point.
constexpr std::size_t most_sum_bits = 10000;
/// Of the numbers of a trend that are kept as they are; others are rounded to so many digits.
constexpr std::size_t most_trend_bits = 128;
constexpr int trend_digits = 20;
constexpr std::string_view blanks = " \t";
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

struct Columns {
  std::array<std::string_view, 2> texts;  ///< the first two
  std::size_t count = 0;
};

/// Of a line that is not blank.
Columns columns_of(std::string_view line) {
  Columns columns;
  const std::string_view separators = line.find(';') != line.npos ? ";" : line.find(',') != line.npos ? "," : blanks;
  while (true) {
    const std::size_t end = line.find_first_of(separators);
    if (columns.count < 2) columns.texts[columns.count] = trimmed(line.substr(0, end));
    ++columns.count;
    if (end == line.npos) return columns;
    line = line.substr(end + 1);
    if (separators == blanks) line = trimmed(line);
  }
}

Rational of_trend(const Rational& value) {
  return bits(value) <= most_trend_bits ? value : parse_rational(full_number(value, trend_digits));
}

/// Sums of points for their mean, or for the line of least squares.
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

  /// Of two different x at least.
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
      : name_(name), support_(support), heights_(heights) {}

  ProfileTrace parse(std::string_view text) {
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    pieces_.reserve(std::min(lines, max_trace_points));
    while (!text.empty()) {
      ++line_;
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      read(line);
    }
    if (points_ < 2) throw error("too few points", "a trace has at least 2", fmt::format("{} points", points_));
    std::optional<Trend> trend;
    if (heights_.detrend != Detrend::none) {
      trend = sums_.trend(heights_.detrend);
      take_off(*trend);
    }
    return {points_, {first_, x_}, std::move(pieces_), std::move(trend)};
  }

 private:
  void read(std::string_view line) {
    if (line.size() > longest_trace_line) {
      throw error("line too long", fmt::format("a line of a trace has at most {} characters", longest_trace_line),
                  fmt::format("{} characters", line.size()));
    }
    if (line.find('\0') != line.npos) throw error("not a text", "a trace has no NUL bytes", excerpt(line));
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) return;
    const bool is_first = !std::exchange(begun_, true);
    if (is_first && std::string_view("+-.0123456789").find(line.front()) == std::string_view::npos) return;
    const Columns columns = columns_of(line);
    if (columns.count != 2) {
      throw error("wrong number of columns", "a line of a trace is x,psi", fmt::format("{} columns", columns.count));
    }
    Rational x = number("x", columns.texts[0]);
    add(std::move(x), heights_.factor * number("psi", columns.texts[1]));
  }

  Rational number(const std::string& column, std::string_view text) const {
    try {
      return parse_rational(text);
    } catch (const InvalidData& invalid) {
      throw error(column + ": " + invalid.what());
    }
  }

  void add(Rational x, Rational psi) {
    if (points_ == max_trace_points) {
      throw error("too many points", fmt::format("a trace has at most {}", max_trace_points), "more");
    }
    if (heights_.detrend != Detrend::none) sums_.add(x, psi, heights_.detrend == Detrend::line);
    if (sums_.is_too_long()) {
      throw error("trace too complicated to detrend", "sums over its numbers are limited in digits", "more");
    }
    if (points_ == 0) {
      first_ = x;
    } else if (x <= x_) {
      throw error("x: not increasing", "x increases from line to line", to_string(x) + " after " + to_string(x_));
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
    throw error("trace too complicated", "all numbers together are limited in digits", "more");
  }

  InvalidFile error(const std::string& what) const {
    return InvalidFile(fmt::format("{}:{}: {}", name_, std::max<std::size_t>(line_, 1), what));
  }
  InvalidFile error(const std::string& what, const std::string& rule, const std::string& value) const {
    return error(what + "; " + rule + "; " + value);
  }

  const std::string& name_;
  const std::optional<Support>& support_;
  const Heights& heights_;
  TrendSums sums_;
  std::size_t line_ = 0;
  bool begun_ = false;
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
