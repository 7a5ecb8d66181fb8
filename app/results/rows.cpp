#include "app/results/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <charconv>
#include <cmath>
#include <utility>

#include "model/rational.hpp"

namespace steadyslide::app {

using Json = nlohmann::ordered_json;

namespace {

using Holds = Column::Holds;

/// The words of a cell, or one of the texts of its number or numbers.
std::vector<std::string> texts(const Cell& cell, std::string NumberText::*text) {
  if (const auto* word = std::get_if<std::string>(&cell)) return {*word};
  if (const auto* words = std::get_if<std::vector<std::string>>(&cell)) return *words;
  if (const auto* number = std::get_if<NumberText>(&cell)) return {number->*text};
  std::vector<std::string> list;
  for (const NumberText& number : std::get<std::vector<NumberText>>(cell)) list.push_back(number.*text);
  return list;
}

std::string joined(const Cell& cell, std::string NumberText::*text = &NumberText::shown) {
  return fmt::format("{}", fmt::join(texts(cell, text), " "));
}

Json json_of(const Cell& cell, Holds holds) {
  const auto word = holds == Holds::decimals ? decimal_json : text_json;
  if (const auto* text = std::get_if<std::string>(&cell)) return word(*text);
  if (const auto* number = std::get_if<NumberText>(&cell)) return number_json(*number);
  Json list = Json::array();
  if (const auto* words = std::get_if<std::vector<std::string>>(&cell)) {
    for (const std::string& one : *words) list.push_back(word(one));
    return list;
  }
  for (const NumberText& number : std::get<std::vector<NumberText>>(cell)) list.push_back(number_json(number));
  return list;
}

/// Aligned text. It keeps all rows until the widths are known.
class TextRows final : public RowWriter {
 public:
  TextRows(std::vector<Column> columns, Output& output, std::size_t indent = 0)
      : RowWriter(std::move(columns), output), indent_(indent, ' '), widths_(columns_.size()) {
    for (const Column& column : columns_) add(column.name);
  }

  void row(const std::vector<Cell>& cells) override {
    for (const Cell& cell : cells) {
      const std::string text = joined(cell);
      add(text.empty() ? "-" : text);
    }
  }

  void end() override {
    std::size_t start = 0;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
      const std::size_t column = k % widths_.size();
      const bool last = column + 1 == widths_.size();
      const std::size_t length = ends_[k] - start;
      if (column == 0) output_.write(indent_);
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

  std::string indent_;
  std::vector<std::size_t> widths_;
  std::string text_;               // all cells, one after the other
  std::vector<std::size_t> ends_;  // the end of each cell in text_
};

/// An array of objects, the columns' names as keys.
class JsonRows final : public RowWriter {
 public:
  using RowWriter::RowWriter;

  void row(const std::vector<Cell>& cells) override {
    output_.write((first_ ? "[\n  " : ",\n  ") + row_json(columns_, cells).dump());
    first_ = false;
  }

  void end() override { output_.write(first_ ? "[]\n" : "\n]\n"); }

 private:
  bool first_ = true;
};

/// RFC 4180, with line feeds. The errors are the last columns.
class CsvRows final : public RowWriter {
 public:
  CsvRows(std::vector<Column> columns, Output& output) : RowWriter(std::move(columns), output) {
    std::vector<std::string> header;
    for (const Column& column : columns_) header.push_back(column.name);
    for (const Column& column : columns_) {
      if (column.holds == Holds::numbers) header.push_back(column.name + "_error");
    }
    write(header);
  }

  void row(const std::vector<Cell>& cells) override {
    std::vector<std::string> fields;
    for (const Cell& cell : cells) fields.push_back(joined(cell, &NumberText::value));
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (columns_[k].holds == Holds::numbers) fields.push_back(joined(cells[k], &NumberText::error));
    }
    write(fields);
  }

 private:
  void write(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) line += csv_field(field) + ",";
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

  void row(const std::vector<Cell>& cells) override {
    std::string line = "|";
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::string_view quote = columns_[k].holds == Holds::formulas ? "$" : "";
      line += fmt::format(" {0}{1}{0} |", quote, joined(cells[k]));
    }
    output_.write(line + "\n");
  }
};

/// Returns "1.5e-30" as 1.5 \cdot 10^{-30}, other numbers unchanged; empty if the text is not a number.
std::string number_for_math_mode(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789+-.e") != std::string::npos) return "";
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  return fmt::format("{} \\cdot 10^{{{}}}", text.substr(0, e), text.substr(e + 1));
}

/// The page is as wide as the table. The longest cell of a column sets its width.
class LatexRows final : public RowWriter {
 public:
  LatexRows(std::vector<Column> columns, Output& output) : RowWriter(std::move(columns), output) {
    for (const Column& column : columns_) longest_.push_back(column.name.size());
  }

  void row(const std::vector<Cell>& cells) override {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      std::string shown;
      std::size_t length = 0;
      const auto add = [&](const std::string& text) {
        const std::string maths = columns_[k].holds == Holds::formulas ? text : number_for_math_mode(text);
        shown += (shown.empty() ? "" : ", ") + (maths.empty() ? latex_escaped(text) : "$" + maths + "$");
        length += text.size() + 2;
      };
      for (const std::string& text : texts(cells[k], &NumberText::shown)) add(text);
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

/// Writers in the order of Format.
constexpr std::array writers{make<TextRows>, make<JsonRows>, make<CsvRows>, make<MarkdownRows>, make<LatexRows>};

}  // namespace

std::string_view format_name(Format format) {
  constexpr std::array<std::string_view, 5> names{"text", "json", "csv", "markdown", "latex"};
  return names.at(static_cast<std::size_t>(format));
}

Rows::Rows(Format format, std::vector<Column> columns, Output& output)
    : writer_(writers.at(static_cast<std::size_t>(format))(std::move(columns), output)) {}

Rows::Rows(std::vector<Column> columns, Output& output)
    : writer_(std::make_unique<TextRows>(std::move(columns), output, 2)) {}

Json text_json(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json decimal_json(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, value);
  if (text.empty() || read != end || error != std::errc() || !std::isfinite(value)) return text_json(text);
  if (value == 0 && text != "0") return Json(text);
  if (parse_rational(full_number(value, 16)) != parse_rational(text)) return Json(text);
  const bool is_whole = std::abs(value) < 1e15 && value == std::trunc(value);
  return is_whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json number_json(const NumberText& number) {
  return {{number.proved ? "mid" : "value", decimal_json(number.value)},
          {number.proved ? "rad" : "error", decimal_json(number.error)}};
}

Json row_json(const std::vector<Column>& columns, const std::vector<Cell>& cells) {
  Json object;
  for (std::size_t k = 0; k < cells.size(); ++k) object[columns[k].name] = json_of(cells[k], columns[k].holds);
  return object;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  return "\"" + boost::replace_all_copy(text, "\"", "\"\"") + "\"";
}

std::vector<std::vector<std::string>> csv_rows(std::string_view text) {
  std::vector<std::vector<std::string>> rows;
  bool quoted = false, begins = true;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (std::exchange(begins, false)) rows.emplace_back(1);
    std::vector<std::string>& row = rows.back();
    if (quoted && text.substr(k).starts_with("\"\"")) {
      row.back() += text[++k];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (quoted || (c != ',' && c != '\n' && c != '\r')) {
      row.back() += c;
    } else if (c == ',') {
      row.emplace_back();
    } else {
      begins = c == '\n';
    }
  }
  return rows;
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
