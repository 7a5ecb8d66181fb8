#pragma once
// The fits whose spread is the error of one result: windows of several lengths, series of several numbers of terms.

#include <vector>

#include "numeric/estimate.hpp"
#include "numeric/variational/local_fit.hpp"

namespace steadyslide::numeric::variational {

struct FamilyMember {
  Window window;
  int poles;
  int terms;
};

/// `sides`: those looked at. The windows are the same on both.
std::vector<FamilyMember> family(const Cells& cells, const LocalPlace& place, std::span<const Side> sides);

/// Length of the cell next to c on that side.
double cell_length(const Cells& cells, double place, Side side);

/// The window's cells on all sides.
std::vector<Bin> gathered(const Cells& cells, double place, std::span<const Side> sides, const Window& window);

/// Median and spread.
Estimate<double> summary(std::vector<double> values);

}  // namespace steadyslide::numeric::variational
