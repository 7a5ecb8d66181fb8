#pragma once
// Contact on [-1, 1] under a notch, except for a gap around its corner, over a friction jump at 0.

#include "enclosure/contact/contact_panel.hpp"
#include "support/problems.hpp"

namespace steadyslide::enclosure {

struct GapContact {
  using Kind = ContactTopology::Kind;

  Bits bits = 160;
  ReducedProblem problem{reduced({0.1_r, 0.5_r}, {0}, roof(0.2_r, -0.2_r), 1), {0, 1}};
  ContactSet set;
  JacobiRules rules{bits};

  /// The gap is [-e^left, e^right].
  GapContact(int left, int right)
      : set(problem,
            ContactTopology{{{0, {}, Kind::begins, false},
                             {1, Side::left, Kind::ends, true},
                             {1, {}, Kind::interior, false},
                             {1, Side::right, Kind::begins, true},
                             {2, {}, Kind::ends, false}}},
            {Ball(left, bits), Ball(right, bits)}, bits) {}
};

}  // namespace steadyslide::enclosure
