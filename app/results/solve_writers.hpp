#pragma once
// The output formats of `steadyslide solve`.

#include <string>
#include <vector>

#include "app/results/rows.hpp"
#include "app/results/solution_text.hpp"

namespace steadyslide::app {

struct LoadStep {
  std::string load;
  SolutionText solution;
  std::vector<StretchText> until;  ///< of the loads between the step before and this one, where that is to be proved
};

/// A problem as it is given, and with the indenter sliding the other way.
struct BothText {
  SolutionText as_given;
  SolutionText opposite;
  std::vector<std::string> warnings;  ///< of both
};

/// One of the solutions that a search has met.
struct FoundText {
  int times;
  SolutionText variational;
  std::optional<SolutionText> refined;  ///< by the Riemann-Hilbert method; absent where that leads to no solution
};

struct SearchText {
  int starts;
  int unsolved;
  int refinements;  ///< different ones
  std::vector<FoundText> solutions;
  Uniqueness uniqueness;
  std::vector<std::string> warnings;  ///< of all solutions
  std::string failed_condition;       ///< not empty: none of them is a solution, and why

  /// Did every start lead to the same solution?
  bool agreed() const { return solutions.size() == 1 && unsolved == 0; }
};

/// A summary to read, and the samples if there are any.
void write_text(const Problem& problem, const SolutionText& solution, Output& output);
void write_text(const Problem& problem, const SearchText& search, Output& output);
/// The first summary, and the main results of both side by side.
void write_text(const Problem& problem, const BothText& both, Output& output);
/// The whole result, with the problem as read.
void write_json(const Problem& problem, const SolutionText& solution, Output& output);
void write_json(const Problem& problem, const SearchText& search, Output& output);
void write_json(const Problem& problem, const BothText& both, Output& output);
/// One row for each point, or node; without the displacement's gradient.
void write_stresses(Format format, const FieldText& field, Output& output);
void write_nodal_forces(Format format, const FieldText& field, Output& output);
/// Stresses, nodal forces or the largest stress, where one of them was asked for (docs/interior.md). Otherwise
/// the samples, docs/output.md; two rows where a limit differs from its other side.
void write_csv(const Problem& problem, const SolutionText& solution, Output& output);
/// One row for each solution and contact component.
void write_csv(const Problem& problem, const SearchText& search, Output& output);
/// The samples of both, which way the indenter slides in the first column.
void write_csv(const Problem& problem, const BothText& both, Output& output);

/// One row for each load and contact component; without a contact, one row for the load. Where it is to be proved, one row
/// for each stretch between two loads as well.
void write_load_steps(Format format, const std::vector<LoadStep>& steps, bool certify, Output& output);

}  // namespace steadyslide::app
