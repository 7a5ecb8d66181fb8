#pragma once
// Rows of a table in every output format: aligned text, a JSON array of objects, CSV, Markdown, and a complete LaTeX
// document. For a number with an error, text shows the digits that the error supports; CSV has all digits and, after
// the other columns, a column NAME_error; JSON has {"value", "error"} for an estimate and {"mid", "rad"} for a proved
// number; unknown ones are null.

#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/terminal/output.hpp"
#include "library/text/number_format.hpp"

namespace steadyslide::app {

using namespace library;

enum class Format { text, json, csv, markdown, latex };
inline constexpr std::initializer_list<Format> all_formats{Format::text, Format::json, Format::csv, Format::markdown,
                                                           Format::latex};
/// "text", "json", ...
std::string_view format_name(Format format);

struct Column {
  enum class Holds { words, formulas, decimals, numbers };

  Column(const char* its_name, Holds what = Holds::words) : name(its_name), holds(what) {}

  std::string name;
  Holds holds;  ///< formulas are for LaTeX's math mode; decimals have no error, numbers have one
};

/// A text or texts, a number or numbers. Several of them are an array in JSON, and are separated by spaces elsewhere.
using Cell = std::variant<std::string, std::vector<std::string>, NumberText, std::vector<NumberText>>;

/// Rows in one format.
class RowWriter {
 public:
  RowWriter(std::vector<Column> columns, Output& output) : columns_(std::move(columns)), output_(output) {}
  virtual ~RowWriter() = default;

  virtual void row(const std::vector<Cell>& cells) = 0;
  virtual void end() {}

 protected:
  std::vector<Column> columns_;
  Output& output_;
};

class Rows {
 public:
  Rows(Format format, std::vector<Column> columns, Output& output);
  /// A text with two spaces before each row.
  Rows(std::vector<Column> columns, Output& output);

  /// In a text an empty cell is "-", so that columns stay visible.
  void row(const std::vector<Cell>& cells) { writer_->row(cells); }
  /// Call once, after the last row.
  void end() { writer_->end(); }

 private:
  std::unique_ptr<RowWriter> writer_;
};

/// A text; null if it is empty.
nlohmann::ordered_json text_json(const std::string& text);
/// A number if a double has all digits of the text, which holds for 16 digits or fewer; otherwise the text.
nlohmann::ordered_json decimal_json(const std::string& text);
/// A number with its error.
nlohmann::ordered_json number_json(const NumberText& number);
/// Returns an object with the names of the columns as keys.
nlohmann::ordered_json row_json(const std::vector<Column>& columns, const std::vector<Cell>& cells);

/// Returns a field of CSV according to RFC 4180.
std::string csv_field(const std::string& text);

/// Returns the fields of each line of a CSV text. Fields may be quoted, with "" for a quote and with line breaks
/// inside.
std::vector<std::vector<std::string>> csv_rows(std::string_view text);
/// Escapes a text for LaTeX, outside of math mode.
std::string latex_escaped(const std::string& text);

}  // namespace steadyslide::app
