#pragma once
// Reads sections, tables and lists of Markdown files.

#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::proofs_checks {

/// Returns the text between a heading, "## Notation", and the next heading of the same or a higher level. Throws
/// std::logic_error if the page lacks the heading.
std::string_view section_of(std::string_view page, std::string_view heading);

/// Returns the cells of a row: "a" and "b | c" for "| a | b \\| c |". Returns no cells if the line is not a row.
std::vector<std::string> cells_of(std::string_view row);

/// True for the line between a table's heading and its rows: "|---|:-:|".
bool is_rule_of_table(std::string_view row);

/// Returns the parts between the separators; none of an empty text.
std::vector<std::string_view> parts_of(std::string_view text, std::string_view separator);
std::vector<std::string> list_of(std::string_view text, std::string_view separator);

/// Returns the items of a list such as "a(b, c), `d`, e in [0, 1[". Commas within brackets or quotation marks do not
/// separate items. The same square bracket may open one interval and close another. Backticks and a full stop at the
/// end are left out.
std::vector<std::string> items_of(std::string_view text);

}  // namespace steadyslide::proofs_checks
