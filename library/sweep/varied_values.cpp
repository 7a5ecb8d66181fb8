#include "library/sweep/varied_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "library/problem_file/file_error.hpp"
#include "library/problem_file/list_parser.hpp"
#include "library/problem_file/polynomial_parser.hpp"
#include "library/problem_file/problem_reader.hpp"
#include "library/sweep/random_decimals.hpp"
#include "library/text/one_line.hpp"
#include "model/invalid_data.hpp"

namespace steadyslide::library {
namespace {

constexpr std::size_t max_values = 1000000;

enum class Holds { number, polynomial, words };

Holds held(const std::string& path) {
  constexpr std::array words{"sliding", "plane", "samples",     "file",   "x_unit", "height_unit",
                             "detrend", "kind",  "interpolate", "length", "force"};
  const std::string key = path.substr(path.find_last_of('.') + 1);
  if (key == "profile") return Holds::polynomial;
  return std::ranges::find(words, key) == words.end() ? Holds::number : Holds::words;
}

class ValuesReader {
 public:
  ValuesReader(const std::string& path, const Entry& entry, const std::string& file)
      : path_(path), entry_(entry), file_(file), holds_(held(path)) {}

  std::vector<Value> read() const {
    switch (entry_.value.kind) {
      case Value::Kind::list: return list();
      case Value::Kind::table: return random();
      case Value::Kind::text:
        if (holds_ == Holds::number) return range();
        [[fallthrough]];
      default:
        throw bad("not several values",
                  R"(it is an array, a range "0.1:1:0.1" or { random = 9, from = 0, to = 1, seed = 1 })",
                  entry_.value.text.empty() ? name_of(entry_.value.kind) : excerpt(entry_.value.text));
    }
  }

 private:
  InvalidFile bad_at(std::size_t line, const std::string& what) const {
    return {fmt::format("{}:{}", file_, line), path_ + ": " + what};
  }
  InvalidFile bad(const std::string& what, const std::string& rule, const std::string& value) const {
    return bad_at(entry_.value.line, fmt::format("{}; {}; {}", what, rule, value));
  }
  /// Returns what `make` returns. An InvalidData becomes an InvalidFile of this datum.
  template <class Make>
  auto accepted(std::size_t line, Make make) const {
    try {
      return make();
    } catch (const InvalidData& invalid) {
      throw bad_at(line, invalid.what());
    }
  }

  std::vector<Value> list() const {
    const std::vector<Value>& items = entry_.value.items;
    if (items.empty()) throw bad("no values", "there is at least one", "none");
    for (const Value& item : items) check(item);
    return items;
  }

  void check(const Value& value) const {
    using Kind = Value::Kind;
    if (value.kind == Kind::list) {
      for (const Value& item : value.items) check(item);
    } else if (value.kind != Kind::text && value.kind != Kind::integer && value.kind != Kind::decimal) {
      throw bad_at(value.line, fmt::format("wrong type; a value is a number, a string or an array of them; {}",
                                           name_of(value.kind)));
    } else if (holds_ == Holds::number) {
      accepted(value.line, [&] { return parse_rational(value.text); });
    } else if (holds_ == Holds::polynomial) {
      PolynomialBudget budget;
      accepted(value.line, [&] { return parse_polynomial(value.text, budget); });
    }
  }

  std::vector<Value> values(const std::vector<Rational>& numbers) const {
    std::vector<Value> result;
    for (const Rational& number : numbers) {
      Value value;
      value.kind = Value::Kind::text;
      value.line = entry_.value.line;
      value.text = to_string(number);
      result.push_back(std::move(value));
    }
    return result;
  }

  std::vector<Value> range() const {
    const std::string& text = entry_.value.text;
    if (text.find(':') == std::string::npos) {
      throw bad("not a range", "a range is written FIRST:LAST:STEP", excerpt(text));
    }
    return values(accepted(entry_.value.line, [&] { return parse_list(text, max_values); }));
  }

  std::vector<Value> random() const {
    if (holds_ != Holds::number) throw bad("no random values", "only numbers are drawn", "random");
    const ProblemReader reader(entry_.value, file_, "random values");
    reader.check_keys("", {"random", "from", "to", "seed"});
    const auto whole = [&](const char* key, std::uint64_t least, std::uint64_t most, const char* rule) {
      const Value& value = reader.required(key, rule);
      std::uint64_t number = 0;
      const char* const last = value.text.data() + value.text.size();
      const auto [end, error] = std::from_chars(value.text.data(), last, number);
      if (error == std::errc() && end == last && number >= least && number <= most) return number;
      throw bad_at(value.line, fmt::format("{} out of range; {}; {}", key, rule, excerpt(value.text)));
    };
    const std::uint64_t count = whole("random", 1, max_values, "random is how many values, 1 to 1000000");
    const std::uint64_t seed = whole("seed", 0, UINT64_MAX, "the seed is a whole number from 0 to 2^64-1");
    const Rational from = reader.number("from", "random values lie from here on");
    const Rational to = reader.number("to", "random values lie below");
    if (from >= to) throw bad("empty range", "from is less than to", to_string(from) + ", " + to_string(to));
    return values(random_decimals(path_, seed, from, to, count));
  }

  const std::string& path_;
  const Entry& entry_;
  const std::string& file_;
  Holds holds_;
};

}  // namespace

std::vector<Value> varied_values(const std::string& path, const Entry& entry, const std::string& file) {
  return ValuesReader(path, entry, file).read();
}

}  // namespace steadyslide::library
