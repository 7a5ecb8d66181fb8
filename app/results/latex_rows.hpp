#pragma once
// Rows as a LaTeX document that compiles as it is, with what every LaTeX has (longtable).

#include "app/results/row_writer.hpp"

namespace steadyslide::app {

std::unique_ptr<RowWriter> make_latex_rows(std::vector<Column> columns, Output& output);

}  // namespace steadyslide::app
