#include "library/problem_file/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "library/text/one_line.hpp"
#include "model/invalid_data.hpp"

namespace steadyslide::library {
namespace {

constexpr std::size_t longest_table_line = 1000;
constexpr std::string_view blanks = " \t";
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// The columns of a line that is not blank.
std::vector<std::string_view> columns_of(std::string_view line) {
  std::vector<std::string_view> columns;
  const std::string_view separators = line.find(';') != std::string_view::npos   ? ";"
                                      : line.find(',') != std::string_view::npos ? ","
                                                                                 : blanks;
  while (true) {
    const std::size_t end = line.find_first_of(separators);
    columns.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return columns;
    line = line.substr(end + 1);
    if (separators == blanks) line = trimmed(line);
  }
}

}  // namespace

void TableReader::read(std::string_view text, const std::function<void(std::vector<Rational>&)>& row) {
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
  while (!text.empty()) {
    ++line_;
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    read_line(line, row);
  }
}

void TableReader::read_line(std::string_view line, const std::function<void(std::vector<Rational>&)>& row) {
  if (line.size() > longest_table_line) {
    throw error("line too long", fmt::format("a line of {} has at most {} characters", rules_.kind, longest_table_line),
                fmt::format("{} characters", line.size()));
  }
  if (line.find('\0') != std::string_view::npos)
    throw error("not a text", rules_.kind + " has no NUL bytes", excerpt(line));
  line = trimmed(line.substr(0, line.find('#')));
  if (line.empty()) return;
  const bool is_first = !std::exchange(begun_, true);
  if (is_first && std::string_view("+-.0123456789").find(line.front()) == std::string_view::npos) return;
  const std::vector<std::string_view> columns = columns_of(line);
  if (columns.size() < rules_.fewest_columns || columns.size() > rules_.columns.size()) {
    throw error("wrong number of columns", fmt::format("a line of {} is {}", rules_.kind, rules_.row),
                fmt::format("{} columns", columns.size()));
  }
  std::vector<Rational> numbers;
  for (std::size_t i = 0; i < columns.size(); ++i) numbers.push_back(number(rules_.columns[i], columns[i]));
  row(numbers);
}

Rational TableReader::number(const std::string& column, std::string_view text) const {
  try {
    return parse_rational(text);
  } catch (const InvalidData& invalid) {
    throw error(column + ": " + invalid.what());
  }
}

InvalidFile TableReader::error_at(std::size_t line, const std::string& what) const {
  if (!name_.ends_with("[]")) return InvalidFile(fmt::format("{}:{}: {}", name_, line, what));
  return InvalidFile(fmt::format("{}{}]: {}", name_.substr(0, name_.size() - 1), line - 1, what));
}

}  // namespace steadyslide::library
