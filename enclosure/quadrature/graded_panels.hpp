#pragma once
// Divides an interval [0, L] with powers at its ends and singular places outside geometrically into panels. The
// distance of each outside place from a panel is at least about `clearance` times the panel's length. The panel at an
// end of the interval has that end's power; for the other panels the end is an outside place. If no place is near, the
// whole interval is one panel.

#include <vector>

#include "enclosure/quadrature/outside_points.hpp"

namespace steadyslide::enclosure {

/// A part of the interval, with all arguments of a PowerPanel.
struct GradedPanel {
  Ball from_left;   ///< from the interval's left end to its left end
  Ball from_right;  ///< from its right end to the interval's right end
  Ball length;
  Ball left;
  Ball right;
  std::vector<OutsidePoint> outside;
};

/// Returns the panels from left to right. A place with the power 0 also counts, because another factor may be singular
/// there. An interval whose length or distances are not certainly positive is not divided; then the remainders of its
/// PowerPanel are not finite.
std::vector<GradedPanel> graded(const Ball& length, const Ball& left, const Ball& right,
                                const std::vector<OutsidePoint>& outside, double clearance = 0.5);

}  // namespace steadyslide::enclosure
