#pragma once
// A uniform mesh solved through coarser ones, each half as fine: the contact found on one is the next one's start.

#include <functional>
#include <optional>

#include "numeric/variational/active_set.hpp"
#include "numeric/variational/certificate.hpp"

namespace steadyslide::numeric::variational {

struct NestedOptions {
  std::size_t cells = 4096;  ///< of the finest mesh
  int most_steps = 100;      ///< of the active sets, on each mesh
  /// The contact that the coarsest mesh starts from, on equal cells of any number; absent: contact everywhere.
  std::optional<CellSet> start = {};
  /// Called after each step: how many of the work's parts are done, of how many, in a measure of their cost.
  std::function<void(std::size_t done, std::size_t total)> progress = {};
};

/// The solution on one mesh.
struct MeshSolution {
  std::shared_ptr<const DiscreteProblem> problem;
  ActiveSetResult found;
  bool by_lemke = false;  ///< the active sets cycled and Lemke's method went on
};

struct NestedResult {
  MeshSolution fine;
  MeshSolution coarse;  ///< on half as many cells: the difference shows the error
  Certificate certificate;
};

NestedResult solve_nested(const ContactProblem& problem, const NestedOptions& options);

/// A contact set on `cells` equal cells, from one on any other number of them.
CellSet prolonged(const CellSet& set, std::size_t cells);

}  // namespace steadyslide::numeric::variational
