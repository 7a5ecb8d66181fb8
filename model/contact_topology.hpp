#pragma once
// The points of a contact set, without coordinates: every anchor of the reduced problem, and the free ends of contact.

#include <optional>
#include <string>
#include <vector>

#include "model/direction.hpp"
#include "model/reduced_problem.hpp"

namespace steadyslide {

struct ContactTopology {
  enum class Kind { interior, begins, ends };  ///< interior, or contact begins or ends here, from left to right

  struct Point {
    std::size_t anchor;               ///< the point is at this anchor,
    std::optional<Side> beside = {};  ///< or, if set, a free end on this side of the anchor
    Kind kind = Kind::interior;
    bool vanishes = false;  ///< an end where the traction vanishes

    bool is_end() const { return kind != Kind::interior; }
    friend bool operator==(const Point&, const Point&) = default;
  };

  /// From left to right. Every anchor is one of them.
  std::vector<Point> points;

  /// Returns the indices of the points that can move.
  std::vector<std::size_t> movable() const;
  /// Returns the number of free ends (at anchors or not) minus the number of components: the degree S of Y at infinity.
  int degree_at_infinity() const;
  /// Returns the reason why this is not a contact set of the problem; empty if it is one.
  std::string fault(const ReducedProblem& problem) const;
  friend bool operator==(const ContactTopology&, const ContactTopology&) = default;
};

}  // namespace steadyslide
