#pragma once
// A lower bound of H (cell_gap.hpp) over the whole support: parts of cells are halved until what H may dip below its values
// at their ends no longer matters.

#include <limits>
#include <optional>

#include "enclosure/cells/cell_gap.hpp"
#include "enclosure/number/work_budget.hpp"

namespace steadyslide::enclosure {

struct LowestGap {
  Ball bound;      ///< H >= bound everywhere, exact
  Ball somewhere;  ///< H <= somewhere at one place at least: how sharp the bound is
  std::size_t intervals = 0;
  /// The cell that was searched when the budget of work was spent; absent where the search has ended.
  std::optional<std::size_t> unfinished = {};
};

/// `mean`: of H under the pressures. `low`: H <= low somewhere. Within a 256th of mean - min H.
LowestGap lowest_gap(const CellGap& gap, const Ball& mean, const Ball& low, WorkBudget& work);

}  // namespace steadyslide::enclosure
