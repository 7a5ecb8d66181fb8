#include "library/problem_file/profile_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "library/problem_file/file_error.hpp"
#include "library/problem_file/polynomial_parser.hpp"
#include "library/text/one_line.hpp"
#include "model/invalid_data.hpp"

namespace steadyslide::library {
namespace {

constexpr std::size_t longest_trace_line = 1000;
/// Bits of all coefficients together: about twice those of 10^6 points with 17 digits each.
constexpr std::size_t most_bits = 1000000000;
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

class TraceParser {
 public:
  TraceParser(const std::string& name, const std::optional<Support>& support) : name_(name), support_(support) {}

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
    return {points_, {first_, x_}, std::move(pieces_)};
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
    add(std::move(x), number("psi", columns.texts[1]));
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
    if (points_ == 0) {
      first_ = x;
    } else if (x <= x_) {
      throw error("x: not increasing", "x increases from line to line", to_string(x) + " after " + to_string(x_));
    } else if (!support_ || (x > support_->left && x_ < support_->right)) {
      const Rational slope = (psi - psi_) / (x - x_);
      Rational height = psi - slope * x;
      bits_ += bits(x) + bits(slope) + bits(height);
      if (bits_ > most_bits) {
        throw error("trace too complicated", "all numbers together are limited in digits", "more");
      }
      pieces_.push_back({support_ ? std::min(x, support_->right) : x, Polynomial({std::move(height), slope})});
    }
    x_ = std::move(x);
    psi_ = std::move(psi);
    ++points_;
  }

  InvalidFile error(const std::string& what) const {
    return InvalidFile(fmt::format("{}:{}: {}", name_, std::max<std::size_t>(line_, 1), what));
  }
  InvalidFile error(const std::string& what, const std::string& rule, const std::string& value) const {
    return error(what + "; " + rule + "; " + value);
  }

  const std::string& name_;
  const std::optional<Support>& support_;
  std::size_t line_ = 0;
  bool begun_ = false;
  std::size_t points_ = 0;
  std::size_t bits_ = 0;
  Rational first_, x_, psi_;
  std::vector<Indenter::Piece> pieces_;
};

}  // namespace

ProfileTrace parse_trace(std::string_view text, const std::string& name, const std::optional<Support>& support) {
  return TraceParser(name, support).parse(text);
}

}  // namespace steadyslide::library
