#pragma once
// The contact problem in reduced quantities, exact: xi = (x - origin)/unit, heights psi/(c unit), so that the slope
//
//   g(xi) = psi'(x)/c,   A t = g + tilt on the contact,   int t dxi = -load,   load = P/unit,
//
// for one load, or for all loads of an interval, whose middle and radius are exact: what is then proved holds for each.
// Places that are data (ends of the support, friction jumps, breaks of the profile) are anchors, in order.

#include <optional>
#include <vector>

#include "enclosure/number/ball.hpp"
#include "model/contact_problem.hpp"

namespace steadyslide::enclosure {

/// Coordinates xi = (x - origin)/unit.
struct Frame {
  Rational origin;
  Rational unit;  ///< > 0
};

struct ReducedProblem {
  ReducedProblem(const ContactProblem& problem, const Frame& frame);
  /// The same for every load from `from` to `to`, in the user's unit. Throws InvalidData unless 0 < from <= to.
  ReducedProblem for_loads(const Rational& from, const Rational& to) const;

  struct Anchor {
    Rational x;     ///< xi
    Rational step;  ///< height on the right minus height on the left; 0 at the ends of the support
  };
  /// Between an anchor and the next one.
  struct Interval {
    Polynomial slope;  ///< g
    Rational s;        ///< +-gamma f
  };

  Frame frame;
  std::vector<Anchor> anchors;
  std::vector<Interval> intervals;
  Rational load;                    ///< in the middle, if there are several ...
  Rational load_radius = 0;         ///< ... as far from it as this
  std::optional<Rational> load_at;  ///< where the load acts, if the indenter may tilt

  /// All of them.
  Ball loads(Bits bits) const { return Ball::plus_or_minus(Ball(load, bits), Ball(load_radius, bits)); }
};

}  // namespace steadyslide::enclosure
