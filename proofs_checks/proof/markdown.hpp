#pragma once
// Sections, tables and lists of Markdown files.

#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::proofs_checks {

/// The text between a heading, "## Notation", and the next one of its level or of a higher one. Throws std::logic_error if the
/// page lacks the heading.
std::string_view section_of(std::string_view page, std::string_view heading);

/// "| a | b \\| c |" has the cells "a" and "b | c"; no cells where the line is no row.
std::vector<std::string> cells_of(std::string_view row);

/// "|---|:-:|": the line between a table's heading and its rows.
bool is_rule_of_table(std::string_view row);

/// The parts between the separators.
std::vector<std::string> list_of(std::string_view text, std::string_view separator);

/// The items of "a(b, c), `d`, e in [0, 1[": the commas between them, not those within brackets of any kind or quotation
/// marks, where what opens an interval may be what closes another. Backticks and a full stop at the end are left out.
std::vector<std::string> items_of(std::string_view text);

}  // namespace steadyslide::proofs_checks
