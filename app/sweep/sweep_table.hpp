#pragma once
// A sweep as rows of CSV: the varied data, the requested results, and failed_condition, which is empty if the problem
// is solved.

#include <string>
#include <vector>

#include "app/commands/solver.hpp"
#include "app/sweep/result_columns.hpp"
#include "library/sweep/sweep_file.hpp"

namespace steadyslide::app {

/// Immutable: several threads may request rows at the same time. No row depends on another one.
class SweepTable {
 public:
  /// Throws Failure if columns or options of [solve] are invalid.
  explicit SweepTable(SweepFile sweep);

  std::size_t size() const { return sweep_.problems.size(); }
  /// Returns one line with the names of the columns.
  std::string header() const;
  /// One line, also for a problem that is not solved.
  std::string row(std::size_t n) const;
  /// The first columns of row(n): the varied data. They need no solution.
  std::string beginning(std::size_t n) const;
  /// Tables with different fingerprints have different rows.
  std::uint64_t fingerprint() const;

 private:
  SolutionText solved(std::size_t n) const;
  std::vector<std::string> data(std::size_t n) const;

  SweepFile sweep_;
  Solver::Wanted wanted_;
  ResultColumns columns_;
  std::vector<std::vector<std::string>> values_;  // the values of each datum as texts
};

/// True for the row of a problem that is not solved.
inline bool is_failed(std::string_view row) { return !row.ends_with(",\n"); }

}  // namespace steadyslide::app
