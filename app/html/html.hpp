#pragma once
// Text as HTML and XML: escaped characters, elements, tables.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::app {

/// Returns a text as the content of an element, for HTML and XML. Drops control characters other than line feed and
/// tab; replaces bytes that are not UTF-8 by U+FFFD.
std::string escaped(std::string_view text);

/// Returns a text as the value of an attribute: like escaped(), but double quotation marks are escaped, too.
std::string escaped_attribute(std::string_view text);

struct Attribute {
  std::string_view name;
  std::string_view value;  ///< not yet escaped
};

/// Returns "<TAG NAME="VALUE">CONTENT</TAG>". The content must be HTML already.
std::string element(std::string_view tag, std::string_view content, std::initializer_list<Attribute> attributes = {});

/// Returns element() with a line feed behind it.
std::string block(std::string_view tag, std::string_view content, std::initializer_list<Attribute> attributes = {});

/// Returns a <span> of the class `kind`. The content must be HTML already.
std::string span(std::string_view kind, std::string_view content);
/// Returns a link to the element `id` of the page. The content must be HTML already.
std::string link(std::string_view content, std::string_view id);
/// Returns a <code> element; escapes `text`.
std::string code(std::string_view text);
/// Returns a block that scrolls by itself, with the keyboard, too. Screen readers read `label`.
std::string region(std::string_view kind, std::string_view label, std::string_view content);

using HtmlRows = std::vector<std::vector<std::string>>;

/// Returns a table. If it is wider than the page, it scrolls by itself; on a phone each row is a card, and each cell
/// names its column (report.js). Columns and rows must be HTML already. A caption gets a number. Screen readers read
/// `label`.
std::string table_element(std::string_view label, const std::vector<std::string>& columns, const HtmlRows& rows,
                          std::string_view caption = {});

/// Returns a <details> element: content that is folded behind a line. If it is closed, only the line is printed.
std::string folded(std::string_view line, std::string_view content);

/// Aligns the decimal points of a column's numbers. They get real minus signs and never break over two lines. Cells
/// that are not numbers stay as they are.
void align_numbers(std::vector<std::string>& cells);

/// Replaces every mark in the text by "NAME 1.", "NAME 2.", ... in order.
std::string with_numbers(std::string html, std::string_view mark, std::string_view name);
inline constexpr std::string_view figure_mark = "<!--figure-->", table_mark = "<!--table-->";

}  // namespace steadyslide::app
