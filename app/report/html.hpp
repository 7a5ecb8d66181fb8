#pragma once
// Text as HTML and XML: escaped characters, elements, tables; nothing else.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::app {

/// Safe as text and inside a quoted attribute, in HTML and in XML alike. Control characters are dropped; bytes that are
/// not UTF-8 become U+FFFD.
std::string escaped(std::string_view text);

struct Attribute {
  std::string_view name;
  std::string_view value;  ///< not yet escaped
};

/// "<TAG NAME="VALUE">CONTENT</TAG>". The content is HTML already.
std::string element(std::string_view tag, std::string_view content, std::initializer_list<Attribute> attributes = {});

/// The same on a line of its own.
std::string block(std::string_view tag, std::string_view content, std::initializer_list<Attribute> attributes = {});

using HtmlRows = std::vector<std::vector<std::string>>;

/// A table that scrolls within itself where it is wider than the page; `label` is for those who cannot see it. Columns
/// and rows are HTML already.
std::string table_element(std::string_view label, const std::vector<std::string>& columns, const HtmlRows& rows);

}  // namespace steadyslide::app
