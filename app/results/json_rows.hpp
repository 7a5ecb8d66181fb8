#pragma once
// Rows as a JSON array of objects, the columns' names as keys; an empty text is null.

#include "app/results/row_writer.hpp"

namespace steadyslide::app {

std::unique_ptr<RowWriter> make_json_rows(std::vector<Column> columns, Output& output);

}  // namespace steadyslide::app
