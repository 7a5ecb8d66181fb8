#pragma once
// Rows in which some cells are numbers with an error. A text shows the digits that the error supports; CSV and JSON
// have all digits and, after the columns of a text, one column NAME_error for each of these.

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "app/results/number_format.hpp"
#include "app/results/row_writer.hpp"

namespace steadyslide::app {

struct NumberColumn {
  std::string name;
  bool has_error = false;
};

using NumberCell = std::variant<std::string, std::vector<std::string>, NumberText, std::vector<NumberText>>;

class NumberRows {
 public:
  NumberRows(Format format, const std::vector<NumberColumn>& columns, Output& output);

  /// Texts in columns without error, numbers in the others. In a text what is empty is "-".
  void row(const std::vector<NumberCell>& cells);
  /// Call once, after the last row.
  void end() { rows_->end(); }

 private:
  bool for_files() const { return format_ == Format::csv || format_ == Format::json; }

  Format format_;
  std::unique_ptr<RowWriter> rows_;
};

}  // namespace steadyslide::app
