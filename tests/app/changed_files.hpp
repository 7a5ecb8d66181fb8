#pragma once
// Tables of files that differ from a good one by a few lines: bad_files.txt says how they are written.

#include <nlohmann/json.hpp>
#include <regex>

#include "support/test.hpp"

namespace steadyslide::testing {

/// The file of lines "~ [table] key = value".
inline std::string file_of(const std::string& changes) {
  static const std::regex pattern(R"(~ (?:(\[\S+\]) ?)?([^=]*?)( = .*)?)");
  nlohmann::ordered_json tables;
  for (const std::string& change : lines(changes)) {
    std::smatch match;
    REQUIRE(std::regex_match(change, match, pattern));
    tables[match.str(1)][match.str(2)] = match[3].matched ? match.str(2) + match.str(3) + "\n" : "";
  }
  std::string text;
  for (const auto& [table, entries] : tables.items()) {
    if (!table.empty()) text += table + "\n";
    for (const auto& [key, line] : entries.items()) text += line.get<std::string>();
  }
  return text;
}

/// As sections_of reads them; the first section, the good file, is none of them.
inline std::vector<std::pair<std::string, std::string>> changed_files(const std::string& table) {
  auto sections = sections_of(table);
  const std::string good = sections.front().second;
  sections.erase(sections.begin());
  for (auto& [head, text] : sections) {
    if (text.starts_with("~ ")) text = file_of(good + text);
  }
  return sections;
}

}  // namespace steadyslide::testing
