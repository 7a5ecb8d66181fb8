#pragma once
// Checks of pictures and pages.

#include <regex>

#include "support/test.hpp"

namespace steadyslide::testing {

/// Checks that every element is closed, in order, with complete attributes, and that there are no bare ampersands.
inline bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t at = 0;
  while ((at = xml.find('<', at)) != std::string::npos) {
    const bool comment = xml.compare(at, 4, "<!--") == 0;
    const std::size_t end = xml.find(comment ? "-->" : ">", at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    at = end;
    if (comment || tag.starts_with("?") || tag.starts_with("!")) continue;
    std::string unquoted;
    char quote = 0;
    for (const char c : tag) {
      if (quote == 0 && c != '"' && c != '\'') unquoted += c;
      if (c == '<' || (quote != 0 && c != quote)) continue;
      quote = quote != 0 ? '\0' : c == '"' || c == '\'' ? c : '\0';
    }
    static const std::regex whole("/?[A-Za-z][\\w]*(\\s+[\\w:.-]+\\s*=)*\\s*/?");
    if (holds(tag, "<") || quote != 0 || !std::regex_match(unquoted, whole)) return false;
    if (tag.back() == '/') continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \t\n"));
    if (name.front() != '/') {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != name) {
      return false;
    } else {
      open.pop_back();
    }
  }
  static const std::set<std::string> references{"&lt", "&gt", "&amp", "&quot", "&apos"};
  for (at = 0; (at = xml.find('&', at)) != std::string::npos; ++at) {
    const std::string reference = xml.substr(at, std::min(xml.find(';', at) - at, std::size_t{10}));
    if (!reference.starts_with("&#") && !references.contains(reference)) return false;
  }
  return open.empty();
}

/// Returns the visible text: the characters of each <text>, each in a line.
inline std::string shown_text(const std::string& svg) {
  std::string result;
  for (std::size_t at = 0; (at = svg.find("<text", at)) != std::string::npos;) {
    const std::size_t end = svg.find("</text>", at);
    result += std::regex_replace(svg.substr(at, end - at), std::regex("<[^>]*>"), "") + '\n';
    at = end;
  }
  return result;
}

}  // namespace steadyslide::testing
