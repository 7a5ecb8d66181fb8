#pragma once
// Cuts an interval [0, L] with powers at its ends and singular places outside into panels, geometrically, so that each place
// outside a panel is about `clearance` times its length away from it, or farther. The panel at an end of the interval keeps
// that end's power; for the others the end is a place outside. Where no place is near, the whole interval is one panel.

#include <vector>

#include "enclosure/quadrature/outside_points.hpp"

namespace steadyslide::enclosure {

/// A part of the interval, and all that a PowerPanel takes.
struct GradedPanel {
  Ball from_left;   ///< of its left end, from the interval's left end
  Ball from_right;  ///< of its right end, from the interval's right end
  Ball length;
  Ball left;
  Ball right;
  std::vector<OutsidePoint> outside;
};

/// From left to right. A place with the power 0 counts as well: something else may be singular there. An interval whose
/// length or distances are not certainly positive is left whole; its PowerPanel says so by remainders that are not finite.
std::vector<GradedPanel> graded(const Ball& length, const Ball& left, const Ball& right,
                                const std::vector<OutsidePoint>& outside, double clearance = 0.5);

}  // namespace steadyslide::enclosure
