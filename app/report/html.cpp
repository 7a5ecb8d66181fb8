#include "app/report/html.hpp"

#include <fmt/format.h>

#include <map>

#include "library/text/utf8.hpp"

namespace steadyslide::app {

std::string escaped(std::string_view text) {
  static const std::map<char, std::string_view> names{{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}};
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const library::Utf8Character character = library::first_character(text);
    const std::size_t length = character.length == 0 ? 1 : character.length;
    const char c = text.front();
    if (character.length == 0) {
      result += "\xef\xbf\xbd";
    } else if (length > 1) {
      // C1 controls and the two noncharacters that XML refuses.
      const bool allowed = character.code >= 0xa0 && character.code != 0xfffe && character.code != 0xffff;
      if (allowed) result += text.substr(0, length);
    } else if (const auto name = names.find(c); name != names.end()) {
      result += name->second;
    } else if (c == '\n' || c == '\t' || (c >= ' ' && c != '\x7f')) {
      result += c;
    }
    text.remove_prefix(length);
  }
  return result;
}

std::string element(std::string_view tag, std::string_view content, std::initializer_list<Attribute> attributes) {
  std::string result = fmt::format("<{}", tag);
  for (const Attribute& a : attributes) result += fmt::format(" {}=\"{}\"", a.name, escaped(a.value));
  return result + fmt::format(">{}</{}>", content, tag);
}

std::string block(std::string_view tag, std::string_view content, std::initializer_list<Attribute> attributes) {
  return element(tag, content, attributes) + "\n";
}

std::string table_element(std::string_view label, const std::vector<std::string>& columns, const HtmlRows& rows) {
  std::string head;
  for (const std::string& column : columns) head += element("th", column, {{"scope", "col"}});
  std::string body;
  for (const std::vector<std::string>& row : rows) {
    std::string cells;
    for (const std::string& cell : row) cells += element("td", cell);
    body += block("tr", cells);
  }
  const std::string table = element("table", block("thead", element("tr", head)) + element("tbody", "\n" + body));
  return block("div", table, {{"class", "wide"}, {"tabindex", "0"}, {"role", "region"}, {"aria-label", label}});
}

}  // namespace steadyslide::app
