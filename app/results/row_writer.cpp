#include "app/results/row_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/results/json_rows.hpp"
#include "app/results/latex_rows.hpp"

namespace steadyslide::app {
namespace {

std::string joined(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return fmt::format("{}", fmt::join(std::get<std::vector<std::string>>(cell), " "));
}

/// Aligned: all rows are kept until the widths are known.
class TextRows final : public RowWriter {
 public:
  TextRows(const std::vector<Column>& columns, Output& output) : output_(output) {
    for (const Column& column : columns) {
      widths_.push_back(0);
      add(column.name);
    }
  }

  void row(const std::vector<Cell>& cells) override {
    for (const Cell& cell : cells) add(joined(cell));
  }

  void end() override {
    std::size_t start = 0;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      const std::size_t column = k % widths_.size();
      const bool last = column + 1 == widths_.size();
      const std::size_t length = ends_[k] - start;
      output_.write(std::string_view(text_).substr(start, length));
      output_.write(last ? "\n" : std::string(widths_[column] - length + 2, ' '));
      start = ends_[k];
    }
  }

 private:
  void add(const std::string& cell) {
    std::size_t& width = widths_[ends_.size() % widths_.size()];
    width = std::max(width, cell.size());
    text_ += cell;
    ends_.push_back(text_.size());
  }

  Output& output_;
  std::vector<std::size_t> widths_;
  std::string text_;               // all cells, one after the other
  std::vector<std::size_t> ends_;  // where each ends
};

/// RFC 4180, with line feeds.
class CsvRows final : public RowWriter {
 public:
  CsvRows(const std::vector<Column>& columns, Output& output) : output_(output) {
    std::vector<Cell> header;
    header.reserve(columns.size());
    for (const Column& column : columns) header.emplace_back(column.name);
    row(header);
  }

  void row(const std::vector<Cell>& cells) override {
    std::string line;
    for (const Cell& cell : cells) line += quoted(joined(cell)) + ",";
    line.back() = '\n';
    output_.write(line);
  }

  void end() override {}

 private:
  static std::string quoted(const std::string& cell) {
    if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
    std::string result = "\"";
    for (const char c : cell) result += c == '"' ? "\"\"" : std::string(1, c);
    return result + "\"";
  }

  Output& output_;
};

class MarkdownRows final : public RowWriter {
 public:
  MarkdownRows(std::vector<Column> columns, Output& output) : columns_(std::move(columns)), output_(output) {
    std::string header = "|";
    std::string rule = "|";
    for (const Column& column : columns_) {
      header += " " + column.name + " |";
      rule += "---|";
    }
    output_.write(header + "\n" + rule + "\n");
  }

  void row(const std::vector<Cell>& cells) override {
    std::string line = "|";
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::string text = joined(cells[k]);
      line += columns_[k].is_latex ? " $" + text + "$ |" : " " + text + " |";
    }
    output_.write(line + "\n");
  }

  void end() override {}

 private:
  std::vector<Column> columns_;
  Output& output_;
};

}  // namespace

std::unique_ptr<RowWriter> make_row_writer(Format format, std::vector<Column> columns, Output& output) {
  switch (format) {
    case Format::text: return std::make_unique<TextRows>(columns, output);
    case Format::json: return make_json_rows(std::move(columns), output);
    case Format::csv: return std::make_unique<CsvRows>(columns, output);
    case Format::markdown: return std::make_unique<MarkdownRows>(std::move(columns), output);
    case Format::latex: return make_latex_rows(std::move(columns), output);
  }
  return nullptr;
}

}  // namespace steadyslide::app
