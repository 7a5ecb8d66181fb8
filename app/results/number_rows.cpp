#include "app/results/number_rows.hpp"

namespace steadyslide::app {
namespace {

bool has_error(const NumberCell& cell) {
  return std::holds_alternative<NumberText>(cell) || std::holds_alternative<std::vector<NumberText>>(cell);
}

/// A cell's words, or one of the texts of its number, or of each of its numbers.
Cell texts(const NumberCell& cell, std::string NumberText::*text) {
  if (const auto* words = std::get_if<std::string>(&cell)) return *words;
  if (const auto* words = std::get_if<std::vector<std::string>>(&cell)) return *words;
  if (const auto* number = std::get_if<NumberText>(&cell)) return number->*text;
  std::vector<std::string> list;
  for (const NumberText& number : std::get<std::vector<NumberText>>(cell)) list.push_back(number.*text);
  return list;
}

}  // namespace

NumberRows::NumberRows(Format format, const std::vector<NumberColumn>& columns, Output& output) : format_(format) {
  std::vector<Column> all;
  for (const NumberColumn& column : columns) all.push_back({column.name});
  for (const NumberColumn& column : columns) {
    if (column.has_error && for_files()) all.push_back({column.name + "_error"});
  }
  rows_ = make_row_writer(format, std::move(all), output);
}

void NumberRows::row(const std::vector<NumberCell>& cells) {
  std::vector<Cell> all;
  for (const NumberCell& cell : cells) {
    all.push_back(texts(cell, for_files() ? &NumberText::value : &NumberText::shown));
    // In a text a column that is sometimes empty could not be told from its neighbour.
    const bool is_empty = all.back() == Cell("") || all.back() == Cell(std::vector<std::string>());
    if (format_ == Format::text && is_empty) all.back() = "-";
  }
  for (const NumberCell& cell : cells) {
    if (for_files() && has_error(cell)) all.push_back(texts(cell, &NumberText::error));
  }
  rows_->row(all);
}

}  // namespace steadyslide::app
