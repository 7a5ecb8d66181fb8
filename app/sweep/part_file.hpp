#pragma once
// A file with rows that take long to compute: FILE.part holds the rows that are ready, in order, each complete. Its
// first line identifies the table, the second one names the columns. FILE.part survives an interrupted program.

#include <cstddef>
#include <string>
#include <string_view>

namespace steadyslide::app {

class PartFile {
 public:
  /// Opens FILE.part for `file`; `title` is its first line. If FILE.part exists and begins with title and header,
  /// `resume` keeps its rows, except for an incomplete last one. Throws Failure: exit code 2 if it exists without
  /// `resume`, or belongs to another table; 3 if it cannot be written, or if another program is writing it.
  PartFile(const std::string& file, const std::string& title, const std::string& header, bool resume);
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  /// The file stays on the disk.
  ~PartFile();

  /// The number of rows in the file. At first it counts the rows of the interrupted program.
  std::size_t rows() const { return rows_; }
  void add(std::string_view row);
  /// Returns header and rows.
  std::string table() const;
  void remove();

 private:
  void read(const std::string& first_lines, bool resume);
  std::string contents() const;
  void write(std::string_view text) const;
  [[noreturn]] void fail(const std::string& what) const;

  std::string name_;
  int descriptor_;
  std::size_t title_;  // length of the first line
  std::size_t rows_ = 0;
};

}  // namespace steadyslide::app
