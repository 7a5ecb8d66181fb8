#pragma once
// A lower bound of H (cell_gap.hpp) over the whole support. Parts of cells are halved until the dip of H below its
// values at their ends is negligible.

#include <limits>
#include <optional>

#include "enclosure/cells/cell_gap.hpp"
#include "enclosure/number/work_budget.hpp"

namespace steadyslide::enclosure {

struct LowestGap {
  Ball bound;      ///< H >= bound everywhere, exact
  Ball somewhere;  ///< H <= somewhere at one place at least; shows the sharpness of the bound
  std::size_t intervals = 0;
  /// The cell that was searched when the work budget was spent; absent if the search is complete.
  std::optional<std::size_t> unfinished = {};
};

/// Returns the bound, with an error of at most (mean - min H)/256. `mean` is the mean of H over the pressures. `low`:
/// H <= low at some place.
LowestGap lowest_gap(const CellGap& gap, const Ball& mean, const Ball& low, WorkBudget& work);

}  // namespace steadyslide::enclosure
