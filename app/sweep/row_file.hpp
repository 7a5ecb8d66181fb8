#pragma once

#include <optional>
#include <string>

#include "app/sweep/part_file.hpp"
#include "app/sweep/sweep.hpp"
#include "app/sweep/sweep_table.hpp"
#include "app/terminal/output.hpp"

namespace steadyslide::app {

/// Where a sweep's rows go: FILE.part, which becomes FILE at the end; or the standard output, row by row.
class RowFile {
 public:
  /// Refuses what it could not write at the end. Throws Failure.
  RowFile(const SweepWanted& wanted, const SweepTable& table);

  /// In order, those of an interrupted sweep included.
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
  std::string text_;  // not written yet, without a part
  std::size_t rows_ = 0;
  std::size_t failures_ = 0;
  std::size_t first_failure_ = 0;
};

}  // namespace steadyslide::app
