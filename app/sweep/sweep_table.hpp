#pragma once
// A sweep as rows of CSV: the varied data, what is asked of the solution, and failed_condition, which is empty where
// the problem is solved.

#include <string>
#include <vector>

#include "app/commands/solver.hpp"
#include "app/sweep/result_columns.hpp"
#include "library/sweep/sweep_file.hpp"

namespace steadyslide::app {

/// Immutable: rows may be asked for by several threads. No row depends on another one.
class SweepTable {
 public:
  /// Throws Failure where columns or the options of [solve] are none.
  explicit SweepTable(SweepFile sweep);

  std::size_t size() const { return sweep_.problems.size(); }
  /// One line of names.
  std::string header() const;
  /// One line; a failure is one, too.
  std::string row(std::size_t n) const;
  /// The first columns of row(n): the varied data, known before anything is solved.
  std::string beginning(std::size_t n) const;
  /// Tables with another one have other rows.
  std::uint64_t fingerprint() const;

 private:
  SolutionText solved(std::size_t n) const;
  std::vector<std::string> data(std::size_t n) const;

  SweepFile sweep_;
  Solver::Wanted wanted_;
  ResultColumns columns_;
  std::vector<std::vector<std::string>> values_;  // as texts, of each datum
};

/// Is it the row of a problem that is not solved?
inline bool is_failed(std::string_view row) { return !row.ends_with(",\n"); }

}  // namespace steadyslide::app
