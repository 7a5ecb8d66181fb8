#include "app/results/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>

namespace steadyslide::app {
namespace {

using Json = nlohmann::ordered_json;
using Holds = Column::Holds;

std::string joined(const TextCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return fmt::format("{}", fmt::join(std::get<std::vector<std::string>>(cell), " "));
}

/// Aligned: all rows are kept until the widths are known.
class TextRows final : public RowWriter {
 public:
  TextRows(std::vector<Column> columns, Output& output)
      : RowWriter(std::move(columns), output), widths_(columns_.size()) {
    for (const Column& column : columns_) add(column.name);
  }

  void row(const std::vector<TextCell>& cells) override {
    for (const TextCell& cell : cells) add(joined(cell));
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

  std::vector<std::size_t> widths_;
  std::string text_;               // all cells, one after the other
  std::vector<std::size_t> ends_;  // where each ends
};

/// An array of objects, the columns' names as keys; an empty text is null.
class JsonRows final : public RowWriter {
 public:
  using RowWriter::RowWriter;

  void row(const std::vector<TextCell>& cells) override {
    Json object;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      std::visit([&](const auto& value) { object[columns_[k].name] = Json(value); }, cells[k]);
      if (cells[k] == TextCell("")) object[columns_[k].name] = nullptr;
    }
    output_.write((first_ ? "[\n  " : ",\n  ") + object.dump());
    first_ = false;
  }

  void end() override { output_.write(first_ ? "[]\n" : "\n]\n"); }

 private:
  bool first_ = true;
};

/// RFC 4180, with line feeds.
class CsvRows final : public RowWriter {
 public:
  CsvRows(std::vector<Column> columns, Output& output) : RowWriter(std::move(columns), output) {
    std::vector<TextCell> header;
    for (const Column& column : columns_) header.emplace_back(column.name);
    row(header);
  }

  void row(const std::vector<TextCell>& cells) override {
    std::string line;
    for (const TextCell& cell : cells) line += csv_field(joined(cell)) + ",";
    line.back() = '\n';
    output_.write(line);
  }
};

class MarkdownRows final : public RowWriter {
 public:
  MarkdownRows(std::vector<Column> columns, Output& output) : RowWriter(std::move(columns), output) {
    std::string header = "|";
    std::string rule = "|";
    for (const Column& column : columns_) {
      header += " " + column.name + " |";
      rule += "---|";
    }
    output_.write(header + "\n" + rule + "\n");
  }

  void row(const std::vector<TextCell>& cells) override {
    std::string line = "|";
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::string_view quote = columns_[k].holds == Holds::formulas ? "$" : "";
      line += fmt::format(" {0}{1}{0} |", quote, joined(cells[k]));
    }
    output_.write(line + "\n");
  }
};

/// "1.5e-30" as 1.5 \cdot 10^{-30}, any other number as it is; empty if the text is no number.
std::string number_for_math_mode(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789+-.e") != std::string::npos) return "";
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  return fmt::format("{} \\cdot 10^{{{}}}", text.substr(0, e), text.substr(e + 1));
}

/// The page is made as wide as the table: the columns are measured by their longest cell.
class LatexRows final : public RowWriter {
 public:
  LatexRows(std::vector<Column> columns, Output& output) : RowWriter(std::move(columns), output) {
    for (const Column& column : columns_) longest_.push_back(column.name.size());
  }

  void row(const std::vector<TextCell>& cells) override {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      std::string shown;
      std::size_t length = 0;
      const auto add = [&](const std::string& text) {
        const std::string maths = columns_[k].holds == Holds::formulas ? text : number_for_math_mode(text);
        shown += (shown.empty() ? "" : ", ") + (maths.empty() ? latex_escaped(text) : "$" + maths + "$");
        length += text.size() + 2;
      };
      if (const auto* text = std::get_if<std::string>(&cells[k])) {
        add(*text);
      } else {
        for (const std::string& text : std::get<std::vector<std::string>>(cells[k])) add(text);
      }
      longest_[k] = std::max(longest_[k], length);
      body_ += shown + (k + 1 < cells.size() ? " & " : " \\\\\n");
    }
  }

  void end() override {
    std::size_t characters = 0;
    for (const std::size_t length : longest_) characters += length + 3;
    const double width = std::clamp(2.1 * static_cast<double>(characters), 170.0, 5000.0);
    std::string header;
    for (const Column& column : columns_) header += (header.empty() ? "" : " & ") + latex_escaped(column.name);
    output_.write(fmt::format(R"(\documentclass{{article}}
\usepackage{{longtable}}
\setlength{{\textwidth}}{{{0:.0f}mm}}
\setlength{{\paperwidth}}{{{1:.0f}mm}}
\setlength{{\pdfpagewidth}}{{{1:.0f}mm}}
\setlength{{\oddsidemargin}}{{-5mm}}
\setlength{{\LTleft}}{{0pt}}
\begin{{document}}
\begin{{longtable}}{{{2}}}
{3} \\ \hline
\endhead
{4}\end{{longtable}}
\end{{document}}
)",
                              width, width + 40, std::string(columns_.size(), 'l'), header, body_));
  }

 private:
  std::vector<std::size_t> longest_;
  std::string body_;
};

template <class Writer>
std::unique_ptr<RowWriter> make(std::vector<Column> columns, Output& output) {
  return std::make_unique<Writer>(std::move(columns), output);
}

/// In the order of Format.
constexpr std::array writers{make<TextRows>, make<JsonRows>, make<CsvRows>, make<MarkdownRows>, make<LatexRows>};

/// A cell's words, or this text of its number, or of each of its numbers.
TextCell texts(const Cell& cell, std::string NumberText::*text) {
  if (const auto* words = std::get_if<std::string>(&cell)) return *words;
  if (const auto* words = std::get_if<std::vector<std::string>>(&cell)) return *words;
  if (const auto* number = std::get_if<NumberText>(&cell)) return number->*text;
  std::vector<std::string> list;
  for (const NumberText& number : std::get<std::vector<NumberText>>(cell)) list.push_back(number.*text);
  return list;
}

}  // namespace

std::string_view format_name(Format format) {
  constexpr std::array<std::string_view, 5> names{"text", "json", "csv", "markdown", "latex"};
  return names.at(static_cast<std::size_t>(format));
}

Rows::Rows(Format format, const std::vector<Column>& columns, Output& output) : format_(format) {
  std::vector<Column> all = columns;
  for (const Column& column : columns) {
    if (column.holds != Holds::numbers || !for_files()) continue;
    all.emplace_back("").name = column.name + "_error";
  }
  writer_ = writers.at(static_cast<std::size_t>(format))(std::move(all), output);
}

void Rows::row(const std::vector<Cell>& cells) {
  std::vector<TextCell> all;
  for (const Cell& cell : cells) {
    all.push_back(texts(cell, for_files() ? &NumberText::value : &NumberText::shown));
    if (format_ == Format::text && joined(all.back()).empty()) all.back() = "-";
  }
  for (const Cell& cell : cells) {
    const bool has_error =
        std::holds_alternative<NumberText>(cell) || std::holds_alternative<std::vector<NumberText>>(cell);
    if (for_files() && has_error) all.push_back(texts(cell, &NumberText::error));
  }
  writer_->row(all);
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  return "\"" + boost::replace_all_copy(text, "\"", "\"\"") + "\"";
}

std::string latex_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("_%&#${}").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

}  // namespace steadyslide::app
