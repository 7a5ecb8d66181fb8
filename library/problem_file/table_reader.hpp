#pragma once
// Tables of numbers in text files.
//
//   Each line is a row. Columns are separated by a semicolon if the line has one, otherwise by a comma if it has one,
//   otherwise by blanks or tabs. The rest of a line from # on is a comment. The first line that is more than a comment
//   is a header unless it begins with a digit, a sign or a point. CRLF and a byte order mark are allowed.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "library/problem_file/file_error.hpp"
#include "model/rational.hpp"

namespace steadyslide::library {

/// The words for a table in error messages.
struct TableRules {
  std::string kind;                  ///< "a trace"
  std::string row;                   ///< "x,psi"
  std::vector<std::string> columns;  ///< names of the columns
  std::size_t fewest_columns;
};

class TableReader {
 public:
  /// `name`: the file, or "FIELD[]" for a table inside a document, which has one row on each line.
  TableReader(std::string name, TableRules rules) : name_(std::move(name)), rules_(std::move(rules)) {}

  /// Calls row(numbers) for each row, with one exact number for each column. Throws InvalidFile.
  void read(std::string_view text, const std::function<void(std::vector<Rational>&)>& row);

  /// The line of the current row; after the last row, the last line of the file.
  std::size_t line() const { return line_ == 0 ? 1 : line_; }
  /// Returns the error "NAME:LINE: what", or "FIELD[LINE - 1]: what".
  InvalidFile error(const std::string& what) const { return error_at(line(), what); }
  InvalidFile error(const std::string& what, const std::string& rule, const std::string& value) const {
    return error(what + "; " + rule + "; " + value);
  }
  InvalidFile error_at(std::size_t line, const std::string& what) const;

 private:
  void read_line(std::string_view text, const std::function<void(std::vector<Rational>&)>& row);
  Rational number(const std::string& column, std::string_view text) const;

  std::string name_;
  TableRules rules_;
  std::size_t line_ = 0;
  bool begun_ = false;
};

}  // namespace steadyslide::library
