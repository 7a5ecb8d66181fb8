#pragma once
// Rows of a table in every output format: aligned text, a JSON array of objects, CSV, Markdown, and a LaTeX document
// that compiles as it is.

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "app/commands/options.hpp"
#include "app/terminal/output.hpp"

namespace steadyslide::app {

struct Column {
  std::string name;
  bool is_latex = false;  ///< its cells are formulas for math mode
};

/// One text, or several: an array in JSON, separated by spaces elsewhere.
using Cell = std::variant<std::string, std::vector<std::string>>;

class RowWriter {
 public:
  virtual ~RowWriter() = default;

  virtual void row(const std::vector<Cell>& cells) = 0;
  /// Call once, after the last row.
  virtual void end() = 0;
};

std::unique_ptr<RowWriter> make_row_writer(Format format, std::vector<Column> columns, Output& output);

}  // namespace steadyslide::app
