#pragma once
// What there is of a file whose rows take long: FILE.part, rows in order, each whole as soon as it is made. Its first line
// says of which table they are, the second one names the columns. It outlives an interrupted program.

#include <cstddef>
#include <string>
#include <string_view>

namespace steadyslide::app {

class PartFile {
 public:
  /// Of `file`; `title` is the first line. Where FILE.part is there already: `resume` takes its rows if it begins with
  /// title and header, without a last one that is not whole. Throws Failure: exit code 2 where it is there and not
  /// wanted, or of another table; 3 where it cannot be written, or is being written by another program.
  PartFile(const std::string& file, const std::string& title, const std::string& header, bool resume);
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  /// The file stays.
  ~PartFile();

  /// Those in it, the first time those of the program before.
  std::size_t rows() const { return rows_; }
  void add(std::string_view row);
  /// Header and rows.
  std::string table() const;
  void remove();

 private:
  void read(const std::string& first_lines, bool resume);
  std::string contents() const;
  void write(std::string_view text) const;
  [[noreturn]] void fail(const std::string& what) const;

  std::string name_;
  int descriptor_;
  std::size_t title_;  // its length
  std::size_t rows_ = 0;
};

}  // namespace steadyslide::app
