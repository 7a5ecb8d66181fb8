#pragma once
// Tables of files that differ from a good one by a few lines. bad_files.txt describes the format.

#include <nlohmann/json.hpp>
#include <regex>

#include "support/test.hpp"

namespace steadyslide::testing {

/// Returns the file of lines "~ [table] key = value".
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

/// Like sections_of, without the good files. A good file is the base of the sections below it.
inline std::vector<std::pair<std::string, std::string>> changed_files(const std::string& table) {
  std::vector<std::pair<std::string, std::string>> files;
  std::string good;
  for (const auto& [head, text] : sections_of(table)) {
    if (head.starts_with("good")) {
      good = text;
    } else {
      files.emplace_back(head, text.starts_with("~ ") ? file_of(good + text) : text);
    }
  }
  return files;
}

}  // namespace steadyslide::testing
