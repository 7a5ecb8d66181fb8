#include "library/problem_file/profile_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "library/problem_file/polynomial_parser.hpp"
#include "library/problem_file/table_reader.hpp"

namespace steadyslide::library {
namespace {

/// Bits of all coefficients together: about twice those of 10^6 points with 17 digits each.
constexpr std::size_t most_bits = 1000000000;

class TraceParser {
 public:
  TraceParser(const std::string& name, const std::optional<Support>& support)
      : reader_(name, {"a trace", "x,psi", {"x", "psi"}, 2}), support_(support) {}

  ProfileTrace parse(std::string_view text) {
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    pieces_.reserve(std::min(lines, max_trace_points));
    reader_.read(text, [this](std::vector<Rational>& row) { add(std::move(row[0]), std::move(row[1])); });
    if (points_ < 2) {
      throw reader_.error("too few points", "a trace has at least 2", fmt::format("{} points", points_));
    }
    return {points_, {first_, x_}, std::move(pieces_)};
  }

 private:
  void add(Rational x, Rational psi) {
    if (points_ == max_trace_points) {
      throw reader_.error("too many points", fmt::format("a trace has at most {}", max_trace_points), "more");
    }
    if (points_ == 0) {
      first_ = x;
    } else if (x <= x_) {
      throw reader_.error("x: not increasing", "x increases from line to line",
                          to_string(x) + " after " + to_string(x_));
    } else if (!support_ || (x > support_->left && x_ < support_->right)) {
      const Rational slope = (psi - psi_) / (x - x_);
      Rational height = psi - slope * x;
      bits_ += bits(x) + bits(slope) + bits(height);
      if (bits_ > most_bits) {
        throw reader_.error("trace too complicated", "all numbers together are limited in digits", "more");
      }
      pieces_.push_back({support_ ? std::min(x, support_->right) : x, Polynomial({std::move(height), slope})});
    }
    x_ = std::move(x);
    psi_ = std::move(psi);
    ++points_;
  }

  TableReader reader_;
  const std::optional<Support>& support_;
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
