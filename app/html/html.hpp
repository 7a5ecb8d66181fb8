#pragma once
// Text as HTML and XML: escaped characters, elements, tables; nothing else.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::app {

/// Returns a text as the content of an element, for HTML and XML. Control characters are dropped; bytes that are not UTF-8
/// become U+FFFD.
std::string escaped(std::string_view text);

/// The same as an attribute's value: double quotation marks are escaped, too.
std::string escaped_attribute(std::string_view text);

struct Attribute {
  std::string_view name;
  std::string_view value;  ///< not yet escaped
};

/// "<TAG NAME="VALUE">CONTENT</TAG>". The content is HTML already.
std::string element(std::string_view tag, std::string_view content, std::initializer_list<Attribute> attributes = {});

/// The same on a line of its own.
std::string block(std::string_view tag, std::string_view content, std::initializer_list<Attribute> attributes = {});

/// With a class; with a link to a place of the page; a text as code. Contents are HTML already, `text` is not.
std::string span(std::string_view kind, std::string_view content);
std::string link(std::string_view content, std::string_view id);
std::string code(std::string_view text);
/// A block that scrolls within itself, by the keyboard, too; `label` is for those who cannot see it.
std::string region(std::string_view kind, std::string_view label, std::string_view content);

using HtmlRows = std::vector<std::vector<std::string>>;

/// A table that scrolls within itself where it is wider than the page; on a phone its rows are cards, in which each cell
/// names its column (report.js). Columns and rows are HTML already. A caption is numbered; without one, `label` is for those who cannot
/// see the table.
std::string table_element(std::string_view label, const std::vector<std::string>& columns, const HtmlRows& rows,
                          std::string_view caption = {});

/// What is folded away behind a line. Closed, it prints as that line.
std::string folded(std::string_view line, std::string_view content);

/// The numbers of a column below each other: decimal points aligned, with real minus signs, never broken. What is no number
/// stays, as HTML.
void align_numbers(std::vector<std::string>& cells);

/// Where the mark stands in a text, "NAME 1", "NAME 2", ... in order.
std::string with_numbers(std::string html, std::string_view mark, std::string_view name);
inline constexpr std::string_view figure_mark = "<!--figure-->", table_mark = "<!--table-->";

}  // namespace steadyslide::app
