#pragma once
// The output formats of `steadyslide solve`.

#include <string>
#include <vector>

#include "app/commands/options.hpp"
#include "app/results/solve_report.hpp"
#include "app/terminal/output.hpp"

namespace steadyslide::app {

/// The whole result, with the problem as read.
void write_solve_json(const Problem& problem, const SolveReport& report, Output& output);
/// A summary to read, and the samples if there are any.
void write_solve_text(const Problem& problem, const SolveReport& report, Output& output);
/// The samples: x,traction,shear,gap,slope and the errors of the last four; two rows where a limit differs from its
/// other side.
void write_solve_csv(const SolveReport& report, Output& output);

struct LoadStep {
  std::string load;
  SolveReport report;
};

/// One of the solutions that a search has met.
struct FoundReport {
  int times;
  SolveReport variational;
  std::optional<SolveReport> refined;  ///< by the Riemann-Hilbert method; absent where that leads to no solution
};

struct SearchReport {
  int starts;
  int unsolved;
  int refinements;  ///< different ones
  std::vector<FoundReport> solutions;
  Uniqueness uniqueness;
  std::vector<std::string> warnings;  ///< of all solutions
  std::string shortcoming;            ///< not empty: none of them is a solution, and why

  /// Did every start lead to the same solution?
  bool agreed() const { return solutions.size() == 1 && unsolved == 0; }
};

void write_search_text(const Problem& problem, const SearchReport& report, Output& output);
void write_search_json(const Problem& problem, const SearchReport& report, Output& output);
/// One row for each solution and contact component.
void write_search_csv(const SearchReport& report, Output& output);

/// One row for each load and contact component; without a contact, one row for the load.
void write_load_steps(Format format, const std::vector<LoadStep>& steps, Output& output);

}  // namespace steadyslide::app
