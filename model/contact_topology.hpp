#pragma once
// The points of a contact set, without numbers: every anchor of the reduced problem, and the free ends of contact.

#include <optional>
#include <string>
#include <vector>

#include "model/direction.hpp"
#include "model/reduced_problem.hpp"

namespace steadyslide {

struct ContactTopology {
  enum class Kind { interior, begins, ends };  ///< contact begins or ends here, from left to right

  struct Point {
    std::size_t anchor;               ///< the anchor itself, or
    std::optional<Side> beside = {};  ///< a free end on this side of it
    Kind kind = Kind::interior;
    bool vanishes = false;  ///< an end where the traction vanishes

    bool is_end() const { return kind != Kind::interior; }
    friend bool operator==(const Point&, const Point&) = default;
  };

  /// Every anchor is among them, left to right.
  std::vector<Point> points;

  /// The points that move: indices.
  std::vector<std::size_t> movable() const;
  /// Free ends, at anchors or not, less the number of components: the degree S of Y at infinity.
  int degree_at_infinity() const;
  /// The reason why this is no contact set of the problem; empty if it is one.
  std::string fault(const ReducedProblem& problem) const;
  friend bool operator==(const ContactTopology&, const ContactTopology&) = default;
};

}  // namespace steadyslide
