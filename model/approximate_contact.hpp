#pragma once
// The contact that a solver found, as exact numbers in the user's x. A proof or a comparison starts from it.

#include <optional>
#include <vector>

#include "model/contact_problem.hpp"

namespace steadyslide {

/// The points of the surface at which contact begins or ends, from left to right: begin, end, begin, end.
struct ApproximateContact {
  struct End {
    /// A place of the data: an end of the support, a jump of the friction, a break of the profile.
    Rational anchor;
    /// The side of the anchor on which the end lies; absent if it lies at the anchor exactly.
    std::optional<Side> beside = {};
    /// The distance from the anchor, > 0. It is stored as such, so that no digits are lost where ends are close to each
    /// other or to an anchor.
    Rational offset = 0;
    /// True if the traction vanishes there. It blows up at an edge.
    bool vanishes = false;
    friend bool operator==(const End&, const End&) = default;
  };
  /// Empty if the method locates the ends to a cell only.
  std::vector<End> ends;

  /// Returns a free end at x. Its anchor is the nearest place of the data; `x` lies strictly between two such places.
  static End free_end(const ContactProblem& problem, const Rational& x);
};

}  // namespace steadyslide
