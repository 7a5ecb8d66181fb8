#pragma once
// A product of powers of the distances to places on the real axis outside an interval [0, L]:
//
//   prod_j (y + d_j)^(p_j)      over places d_j > 0 to the left of 0,
//   prod_j (L - y + d_j)^(p_j)  over places d_j > 0 to the right of L.
//
// It is one exponential of a sum of few logarithms: places with the same or the opposite power share the logarithm of a
// product, and exact integer powers up to 8 need none. Powers that are balls share it if their midpoints are equal:
// with p_j = m + e_j, |e_j| <= r_j, the sum of p_j log d_j lies within sum r_j |log d_j| of m log prod d_j.

#include <vector>

#include "enclosure/number/ball.hpp"
#include "model/direction.hpp"

namespace steadyslide::enclosure {

struct OutsidePoint {
  Side side;
  Ball distance;  ///< from the interval's end on that side, > 0
  Ball power;     ///< with power 0, ellipses avoid the place; for places where another factor is singular
};

class OutsideProduct {
 public:
  explicit OutsideProduct(std::vector<OutsidePoint> points);

  const std::vector<OutsidePoint>& points() const { return points_; }

  /// Returns the product at a place with these distances from the interval's ends. Not finite if a distance may
  /// be <= 0.
  Ball at(const Ball& from_left, const Ball& from_right) const;

  /// Returns a bound in the ellipse with foci 0 and L that reaches `reach` beyond both. Its points z have
  /// d_j - reach <= |z + d_j| <= d_j + L + reach, with equality on the axis. Not finite unless every d_j > reach.
  Ball bound(const Ball& length, const Ball& reach) const;

 private:
  struct Factor {
    std::size_t point;
    bool divides;  ///< true if its power is the opposite of the group's
  };
  struct Group {
    Ball power;  ///< exact
    int whole;   ///< the power, if it is an integer from 1 to 8; otherwise 0
    std::vector<Factor> factors;
  };

  std::vector<OutsidePoint> points_;
  std::vector<Group> groups_;
};

}  // namespace steadyslide::enclosure
