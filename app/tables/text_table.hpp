#pragma once
// A table of a document, as texts. Computed numbers are already formatted. Words are plain text; formulas stand between
// backticks in ASCII, `alpha_-`, `1/2 - alpha`.

#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::app {

struct TextTable {
  std::string title;
  std::string note;  ///< paragraphs, each on one line
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< as many cells as columns
  std::vector<std::string> references;         ///< works cited in the note or the rows: a key, author, title, ...
};

/// Returns the cells of a row of a Markdown table, "| a | b |".
std::vector<std::string> cells_of_row(std::string_view line);

/// Returns a document in Markdown; the formulas stay unchanged.
std::string markdown_document(const std::string& title, const std::vector<TextTable>& tables);

/// Returns a complete LaTeX document in ASCII, with formulas in math mode. It needs longtable.
std::string latex_document(const std::string& title, const std::vector<TextTable>& tables);

/// Returns CSV (RFC 4180) with one line for each cell: table, row (from 1), column, value. The formulas are without
/// backticks.
std::string csv_document(const std::vector<TextTable>& tables);

}  // namespace steadyslide::app
