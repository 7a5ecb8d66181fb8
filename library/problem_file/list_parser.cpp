#include "library/problem_file/list_parser.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/split.hpp>
#include <charconv>
#include <string>

#include "library/text/one_line.hpp"
#include "model/invalid_data.hpp"

namespace steadyslide::library {
namespace {

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  return boost::algorithm::split(parts, text, [=](char c) { return c == separator; });
}

InvalidData bad_list(const std::string& problem, const std::string& rule, std::string_view value) {
  return {"", problem, rule, excerpt(value)};
}

InvalidData too_long(std::size_t most, std::string_view text) {
  return bad_list("list too long", fmt::format("there are at most {} entries", most), text);
}

std::vector<Rational> parse_range(std::string_view text, std::size_t most) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() != 3) throw bad_list("not a range", "a range is written FIRST:LAST:STEP", text);
  const Rational first = parse_rational(parts[0]);
  const Rational last = parse_rational(parts[1]);
  const Rational step = parse_rational(parts[2]);
  if (step <= 0) throw bad_list("step out of range", "the step is positive", parts[2]);
  if (last < first) throw bad_list("empty range", "FIRST is at most LAST", text);
  const Rational steps = (last - first) / step;
  if (steps >= most) throw too_long(most, text);
  std::vector<Rational> list;
  for (Rational x = first; x <= last; x += step) list.push_back(x);
  return list;
}

}  // namespace

std::vector<Rational> parse_list(std::string_view text, std::size_t most) {
  if (text.find(':') != std::string_view::npos) return parse_range(text, most);
  std::vector<Rational> list;
  for (const std::string& part : split(text, ',')) {
    if (list.size() == most) throw too_long(most, text);
    list.push_back(parse_rational(part));
  }
  return list;
}

int parse_count(std::string_view text, int least, int most) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) {
    throw bad_list("out of range", fmt::format("it is a whole number from {} to {}", least, most), text);
  }
  return value;
}

}  // namespace steadyslide::library
