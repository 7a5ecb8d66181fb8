#pragma once
// Where a solver found contact, as plain exact numbers in the user's x: what it hands to whoever proves or compares.

#include <optional>
#include <vector>

#include "model/contact_problem.hpp"

namespace steadyslide {

/// The points of the surface at which contact begins or ends, left to right, in turns.
struct ApproximateContact {
  struct End {
    /// A place of the data: an end of the support, a jump of the friction, a break of the profile.
    Rational anchor;
    /// The end lies there exactly, or on this side of it.
    std::optional<Side> beside = {};
    /// How far, > 0: ends close to each other or to an anchor keep their distances.
    Rational offset = 0;
    /// Does the traction vanish there? It blows up at an edge.
    bool vanishes = false;
    friend bool operator==(const End&, const End&) = default;
  };
  /// None where a method knows them no better than to a cell.
  std::vector<End> ends;

  /// A free end at x, beside the nearest place of the data. `x` lies strictly between two of them.
  static End free_end(const ContactProblem& problem, const Rational& x);
};

}  // namespace steadyslide
