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
  std::vector<StretchText> until;  ///< proofs for the loads between the step before and this one, if requested
};

/// A problem as given, and with the opposite direction of sliding.
struct BothText {
  SolutionText as_given;
  SolutionText opposite;
  std::vector<std::string> warnings;  ///< for both directions
};

/// Writes a summary for readers, and the samples if there are any.
void write_text(const Problem& problem, const SolutionText& solution, Output& output);
/// The first summary, the main results of both directions side by side, and stresses and forces of the other one.
void write_text(const Problem& problem, const BothText& both, Output& output);
/// Writes the whole result, with the problem as it was read.
void write_json(const Problem& problem, const SolutionText& solution, Output& output);
void write_json(const Problem& problem, const BothText& both, Output& output);
/// Writes stresses, nodal forces or the largest stress, if one of them was requested (docs/finite-elements.md); otherwise the
/// samples (docs/results.md). A sample has two rows if a left and a right limit differ.
void write_csv(const Problem& problem, const SolutionText& solution, Output& output);
/// Writes the same of both directions; the first column is the direction of sliding.
void write_csv(const Problem& problem, const BothText& both, Output& output);

/// Writes one row for each load and contact component; without a contact, one row for the load. If a proof is
/// requested, writes also one row for each stretch between two loads.
void write_load_steps(Format format, const std::vector<LoadStep>& steps, bool certify, Output& output);

}  // namespace steadyslide::app
