#pragma once
// The contact problem in reduced quantities, exact: xi = (x - origin)/unit, heights psi/(c unit), so that the slope
//
//   g(xi) = psi'(x)/c,   A t = g + tilt on the contact,   int t dxi = -load,   load = P/unit,
//
// for one load, or for all loads of an interval. Places of the data (ends of the support, friction jumps, breaks of the
// profile) are anchors, left to right; interval k lies between the anchors k and k + 1.

#include <optional>
#include <vector>

#include "model/contact_problem.hpp"

namespace steadyslide {

/// The coordinates xi = (x - origin)/unit. A, t and g do not change when x is scaled.
struct Frame {
  Rational origin;
  Rational unit;  ///< > 0
};

struct ReducedProblem {
  ReducedProblem(const ContactProblem& problem, const Frame& frame);
  /// Returns the reduced problem for all loads from `from` to `to`, in the user's unit. Throws InvalidData unless
  /// 0 < from <= to.
  ReducedProblem for_loads(const Rational& from, const Rational& to) const;

  /// A place of the data, in xi, with the jumps of the height and of g there. They are 0 at the ends of the support.
  using Anchor = Indenter::Break;
  struct Interval {
    std::size_t slope;     ///< index into `slopes`
    std::size_t friction;  ///< index of the friction value
    Rational s;            ///< +-gamma f
  };

  /// Returns the anchor's place in the user's x.
  Rational place(std::size_t anchor) const { return frame.origin + frame.unit * anchors[anchor].x; }

  Frame frame;
  std::vector<Anchor> anchors;
  std::vector<Interval> intervals;
  std::vector<Polynomial> slopes;   ///< g: the different polynomials, in the order of their first interval
  Rational load;                    ///< the midpoint, if there is an interval of loads
  Rational load_radius = 0;         ///< half the length of that interval
  std::optional<Rational> load_at;  ///< where the load acts, if the indenter may tilt
};

}  // namespace steadyslide
