#include "app/commands/points_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>

#include "app/terminal/failure.hpp"
#include "model/invalid_data.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t longest_points_line = 1000;

std::vector<std::string> split_columns(const std::string& line) {
  const bool semicolons = line.find(';') != line.npos;
  const bool commas = line.find(',') != line.npos;
  std::vector<std::string> texts;
  boost::algorithm::split(texts, line,
                          boost::is_any_of(semicolons ? ";"
                                           : commas   ? ","
                                                      : " \t"),
                          semicolons || commas ? boost::token_compress_off : boost::token_compress_on);
  for (std::string& text : texts) boost::algorithm::trim(text);
  return texts;
}

}  // namespace

std::vector<std::vector<Rational>> parse_points(std::string_view text, const std::string& name,
                                                const std::vector<std::string>& columns, std::size_t most) {
  std::size_t number = 0;
  const auto error = [&](const std::string& what) {
    return Failure(ExitCode::bad_input, fmt::format("{}:{}: {}", name, std::max<std::size_t>(number, 1), what));
  };
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  std::istringstream lines{std::string(text)};
  std::vector<std::vector<Rational>> rows;
  bool begun = false;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.size() > longest_points_line) {
      throw error(fmt::format("line too long; a line has at most {} characters; {} characters", longest_points_line,
                              line.size()));
    }
    if (line.find('\0') != line.npos) throw error("not a text; there are no NUL bytes; " + excerpt(line));
    line.erase(std::min(line.find('#'), line.size()));
    boost::algorithm::trim(line);
    if (line.empty()) continue;
    const bool is_header = !begun && std::string_view("+-.0123456789").find(line.front()) == std::string_view::npos;
    begun = true;
    if (is_header) continue;
    const std::vector<std::string> texts = split_columns(line);
    if (texts.size() != columns.size()) {
      throw error(
          fmt::format("wrong number of columns; a line is {}; {} columns", fmt::join(columns, ","), texts.size()));
    }
    if (rows.size() == most) throw error(fmt::format("too many points; there are at most {}; more", most));
    std::vector<Rational>& row = rows.emplace_back();
    for (std::size_t k = 0; k < texts.size(); ++k) {
      try {
        row.push_back(parse_rational(texts[k]));
      } catch (const InvalidData& invalid) {
        throw error(columns[k] + ": " + invalid.what());
      }
    }
  }
  if (rows.empty()) throw error("no points; there is at least 1; 0 points");
  return rows;
}

std::vector<std::vector<Rational>> read_points(const std::string& name, const std::vector<std::string>& columns,
                                               std::size_t most) {
  std::ostringstream text;
  if (name == "-") {
    text << std::cin.rdbuf();
  } else {
    std::ifstream file(name, std::ios::binary);
    if (file) text << file.rdbuf();
    if (!file) {
      const int why = errno;
      throw Failure(ExitCode::failed, fmt::format("{}: cannot be read: {}", name, std::strerror(why)));
    }
  }
  return parse_points(text.str(), name, columns, most);
}

}  // namespace steadyslide::app
