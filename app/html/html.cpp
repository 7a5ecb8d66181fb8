#include "app/html/html.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <map>
#include <regex>

#include "library/text/utf8.hpp"

namespace steadyslide::app {

std::string escaped(std::string_view text) {
  static const std::map<char, std::string_view> names{{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}};
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const library::Utf8Character character = library::first_character(text);
    const std::size_t length = character.length == 0 ? 1 : character.length;
    const char c = text.front();
    if (character.length == 0) {
      result += "\xef\xbf\xbd";
    } else if (length > 1) {
      // Drops C1 control characters, and the two noncharacters that XML forbids.
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

std::string escaped_attribute(std::string_view text) { return boost::replace_all_copy(escaped(text), "\"", "&quot;"); }

std::string element(std::string_view tag, std::string_view content, std::initializer_list<Attribute> attributes) {
  std::string result = fmt::format("<{}", tag);
  for (const Attribute& a : attributes) result += fmt::format(" {}=\"{}\"", a.name, escaped_attribute(a.value));
  return result + fmt::format(">{}</{}>", content, tag);
}

std::string block(std::string_view tag, std::string_view content, std::initializer_list<Attribute> attributes) {
  return element(tag, content, attributes) + "\n";
}

std::string span(std::string_view kind, std::string_view content) {
  return element("span", content, {{"class", kind}});
}

std::string link(std::string_view content, std::string_view id) {
  return element("a", content, {{"href", "#" + std::string(id)}});
}

std::string code(std::string_view text) { return element("code", escaped(text)); }

std::string region(std::string_view kind, std::string_view label, std::string_view content) {
  return block("div", content, {{"class", kind}, {"tabindex", "0"}, {"role", "region"}, {"aria-label", label}});
}

namespace {

constexpr std::string_view number_class = "<span class=\"n\">";

bool holds_numbers(const HtmlRows& rows, std::size_t column) {
  const auto is_number = [&](const auto& row) { return row.at(column).starts_with(number_class); };
  return !rows.empty() && std::ranges::all_of(rows, is_number);
}

}  // namespace

std::string table_element(std::string_view label, const std::vector<std::string>& columns, const HtmlRows& rows,
                          std::string_view caption) {
  std::vector<std::string> head, cells_open;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::string_view right = holds_numbers(rows, k) ? R"( class="right")" : "";
    head.push_back(fmt::format(R"(<th scope="col"{}>{}</th>)", right, columns[k]));
    cells_open.push_back(fmt::format("<td{}>", right));
  }
  std::string body;
  for (const std::vector<std::string>& row : rows) {
    std::string cells;
    for (std::size_t k = 0; k < row.size(); ++k) cells += cells_open.at(k) + row[k] + "</td>";
    body += block("tr", cells);
  }
  const std::string title =
      caption.empty() ? "" : block("caption", fmt::format("<strong>{}</strong> {}", table_mark, caption));
  const std::string table =
      element("table", title + block("thead", element("tr", fmt::format("{}", fmt::join(head, "")))) +
                           element("tbody", "\n" + body));
  return region("wide", label, table);
}

std::string folded(std::string_view line, std::string_view content) {
  return block("details", "\n" + block("summary", line) + std::string(content), {{"class", "fold"}});
}

void align_numbers(std::vector<std::string>& cells) {
  static const std::regex number(R"(-?\d+(\.\d+)?)");
  const auto decimals = [](const std::string& cell) {
    const std::size_t point = cell.find('.');
    return point == std::string::npos ? 0 : cell.size() - point;  // counts the point, too
  };
  std::size_t most = 0;
  for (const std::string& cell : cells) {
    if (std::regex_match(cell, number)) most = std::max(most, decimals(cell));
  }
  for (std::string& cell : cells) {
    if (!std::regex_match(cell, number)) continue;
    std::string digits = cell.starts_with('-') ? "−" + cell.substr(1) : cell;
    if (decimals(cell) == 0 && most > 0) digits += "\u2008";  // as wide as the point
    for (std::size_t k = std::max<std::size_t>(decimals(cell), 1); k < most; ++k) digits += "\u2007";  // as a digit
    cell = std::string(number_class) + digits + "</span>";
  }
}

std::string with_numbers(std::string html, std::string_view mark, std::string_view name) {
  std::size_t at = 0;
  for (int number = 1; (at = html.find(mark, at)) != std::string::npos; ++number) {
    html.replace(at, mark.size(), fmt::format("{} {}.", name, number));
  }
  return html;
}

}  // namespace steadyslide::app
