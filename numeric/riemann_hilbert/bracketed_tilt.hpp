#pragma once
// The tilt as the root of one equation in one unknown. Under a given load the centre of pressure moves strictly towards
// -x as the tilt grows (docs/theory.md, "Attitude"). So it lies at load_at for one tilt, and two tilts with the
// centre on either side bracket it.

#include <functional>
#include <optional>

namespace steadyslide::numeric {

/// Returns the tilt at which `offset` vanishes, to rounding, by TOMS algorithm 748. `offset` is the centre of pressure
/// minus load_at as a function of the tilt; it is absent where the problem with this attitude is not solved. The search
/// for a bracket begins at `start` with steps of `step` > 0, which double, and passes attitudes that are not solved.
/// Absent if there is no bracket, or if an attitude inside it is not solved.
std::optional<double> bracketed_tilt(const std::function<std::optional<double>(double tilt)>& offset, double start,
                                     double step);

}  // namespace steadyslide::numeric
