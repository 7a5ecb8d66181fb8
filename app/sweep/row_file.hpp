#pragma once

#include <optional>
#include <string>

#include "app/sweep/part_file.hpp"
#include "app/sweep/sweep.hpp"
#include "app/sweep/sweep_table.hpp"
#include "app/terminal/output.hpp"

namespace steadyslide::app {

/// The destination of a sweep's rows: FILE.part, which becomes FILE at the end; or the standard output, row by row.
class RowFile {
 public:
  /// Throws Failure if the output could not be written at the end.
  RowFile(const SweepWanted& wanted, const SweepTable& table);

  /// The number of rows so far, in order, including rows of an interrupted sweep.
  std::size_t rows() const { return rows_; }
  void add(const std::string& row);
  /// Call once, after the last row.
  void finish();

  std::size_t failures() const { return failures_; }
  std::size_t first_failure() const { return first_failure_; }  ///< counted from 1

 private:
  void count(std::string_view row);

  const SweepWanted& wanted_;
  std::optional<PartFile> part_;
  std::optional<Output> output_;
  std::string text_;  // without a part file: rows not yet written
  std::size_t rows_ = 0;
  std::size_t failures_ = 0;
  std::size_t first_failure_ = 0;
};

}  // namespace steadyslide::app
