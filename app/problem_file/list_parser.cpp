#include "app/problem_file/list_parser.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/split.hpp>
#include <charconv>

#include "app/terminal/failure.hpp"
#include "model/invalid_data.hpp"

namespace steadyslide::app {
namespace {

Rational entry(const std::string& option, std::string_view text) {
  try {
    return parse_rational(text);
  } catch (const InvalidData& error) {
    throw bad_command_line(option + ": " + error.what());
  }
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  return boost::algorithm::split(parts, text, [=](char c) { return c == separator; });
}

Failure too_long(const std::string& option, std::size_t most, std::string_view text) {
  return bad_command_line(option + ": list too long", fmt::format("there are at most {} entries", most), text);
}

std::vector<Rational> parse_range(const std::string& option, std::string_view text, std::size_t most) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() != 3) {
    throw bad_command_line(option + ": not a range", "a range is written FIRST:LAST:STEP", text);
  }
  const Rational first = entry(option, parts[0]);
  const Rational last = entry(option, parts[1]);
  const Rational step = entry(option, parts[2]);
  if (step <= 0) throw bad_command_line(option + ": step out of range", "the step is positive", parts[2]);
  if (last < first) throw bad_command_line(option + ": empty range", "FIRST is at most LAST", text);
  const Rational steps = (last - first) / step;
  if (steps >= most) throw too_long(option, most, text);
  std::vector<Rational> list;
  for (Rational x = first; x <= last; x += step) list.push_back(x);
  return list;
}

}  // namespace

std::vector<Rational> parse_list(const std::string& option, std::string_view text, std::size_t most) {
  if (text.find(':') != std::string_view::npos) return parse_range(option, text, most);
  std::vector<Rational> list;
  for (const std::string& part : split(text, ',')) {
    if (list.size() == most) throw too_long(option, most, text);
    list.push_back(entry(option, part));
  }
  return list;
}

int parse_count(const std::string& option, std::string_view text, int least, int most) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) {
    throw bad_command_line(option + ": out of range", fmt::format("it is a whole number from {} to {}", least, most),
                           text);
  }
  return value;
}

}  // namespace steadyslide::app
