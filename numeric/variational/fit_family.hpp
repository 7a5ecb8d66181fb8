#pragma once
// The fits whose spread is the error of one result: windows of several lengths, series of several numbers of terms.

#include <vector>

#include "numeric/number/estimate.hpp"
#include "numeric/variational/local_fit.hpp"

namespace steadyslide::numeric::variational {

struct FamilyMember {
  Window window;
  int poles;
  int terms;
};

/// `sides`: those looked at. The windows are the same on both. `crowded`: an unknown exponent beside a polynomial,
/// which leaves less room for other terms; fewer members.
std::vector<FamilyMember> family(const Cells& cells, const LocalPlace& place, std::span<const Side> sides,
                                 bool crowded = false);

/// Length of the cell next to c on that side.
double cell_length(const Cells& cells, double place, Side side);

/// The window's cells on all sides.
std::vector<Bin> gathered(const Cells& cells, double place, std::span<const Side> sides, const Window& window);

/// Median, and largest less smallest value. Where more than a third of the values are no numbers the rest proves
/// nothing: stalled.
Estimate<double> summary(std::vector<double> values);

/// About a free end's own place the first pole vanishes: Newton's step for it from x, where c_-1/(lambda c_0) is
/// `step`; it leaves the step's square. Stays within two cells of `start`.
Estimate<double> moved_place(const Cells& cells, double start, Side side, double x, const Estimate<double>& step);
constexpr int steps_to_place = 4;

}  // namespace steadyslide::numeric::variational
