#include "symbolic/statements/statement_lines.hpp"

#include <algorithm>

namespace steadyslide::symbolic {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

void refuse(const std::string& what, const std::string& text) { throw UnreadableStatement(what + "; " + text); }

std::string to_text(const StatementPlace& place) {
  return place.file + (place.file.empty() ? "" : ", ") + "line " + std::to_string(place.line);
}

std::optional<std::pair<std::string, std::string>> cut(const std::string& text, const std::string& separator) {
  const std::size_t place = text.find(separator);
  if (place == std::string::npos) return std::nullopt;
  return std::pair(trimmed(text.substr(0, place)), trimmed(text.substr(place + separator.size())));
}

std::vector<std::string> split(const std::string& text, const std::string& separator, const std::string& brackets) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    for (const std::string_view pair : {"()", "[]", "{}"}) {
      if (brackets.find(pair[0]) != std::string::npos) depth += (c == pair[0]) - (c == pair[1]);
    }
    if (depth == 0 && text.compare(k, separator.size(), separator) == 0) {
      parts.emplace_back();
      k += separator.size() - 1;
    } else {
      parts.back() += c;
    }
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

std::vector<StatementSection> statement_sections(std::string_view text, StatementPlace& place) {
  constexpr std::size_t indent = 2;
  const std::string file = "file ";
  std::vector<StatementSection> all;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++place.line;
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos || line[first] == '#') continue;
    const std::string content = line.substr(first);
    if (line.starts_with(file)) {
      place = {content.substr(file.size()), 0};
    } else if (first == 0) {
      all.push_back({content, place});
    } else if (all.empty()) {
      refuse("a line belongs to a statement", content);
    } else if (first == indent) {
      const auto words = cut(content + " ", " ");
      all.back().lines.push_back({words->first, words->second, place});
    } else if (all.back().lines.empty()) {
      refuse("a line continues none", content);
    } else {
      std::string& before = all.back().lines.back().rest;
      before += (before.empty() ? "" : " ") + content;
    }
  }
  return all;
}

}  // namespace steadyslide::symbolic
