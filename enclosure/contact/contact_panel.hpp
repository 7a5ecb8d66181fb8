#pragma once
// A Gauss-Jacobi rule for int F |Y|^n dx over a panel. A panel is a part of a segment of the contact set and touches at
// most one of the segment's points. n = 1 or -1, and |Y| is a product of powers of distances to the set's points; one
// power may be lowered by one. Let L be the panel's length, a the power of the point that it touches (0 if none), and F
// analytic with |F| <= M in the panel's Bernstein ellipse rho > 1. The error of the rule with N nodes is at most
//
//   4 mu (L/2)^(a+1) M Q rho^(1-2N)/(rho-1),   mu = int_{-1}^{1} (1+x)^a dx,
//
// with Q the largest product of the other powers on the ellipse. The ellipse reaches L/2 beyond both ends of the
// panel, A = (rho + 1/rho)/2, so a distance D from an end lies between D - (A-1) L/2 and D + L + (A-1) L/2 on it. Three
// ellipses are used. Panels are not longer than their distance from points that they do not touch. Bounds have 64 bits.

#include <array>
#include <functional>
#include <vector>

#include "enclosure/contact/contact_set.hpp"
#include "enclosure/number/ball_polynomial.hpp"
#include "enclosure/quadrature/jacobi_rule.hpp"

namespace steadyslide::enclosure {

/// rho = 16/5, 23/5, 5: the ellipse reaches 0.38, 0.7, 0.8 of the panel's length beyond both ends.
enum class Ellipse { close, beside, far };

class ContactPanel {
 public:
  struct Interval {
    std::size_t segment;
    Ball from_left;   ///< from the segment's left point to the panel's left end; exactly 0 if they touch
    Ball from_right;  ///< from the panel's right end to the segment's right point
    Ball length;
    std::optional<Side> touches;
  };
  struct Node {
    Ball from_left;  ///< distances from the segment's two points
    Ball from_right;
    Ball weight;
    Ball end_weight;  ///< without the powers of the points that the panel does not touch
  };

  /// `lowered` is the point whose power is one less than in |Y|^n.
  ContactPanel(const ContactSet& set, Interval part, int n, std::optional<std::size_t> lowered, int count,
               JacobiRules& rules);

  const Interval& part() const { return part_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Returns the exponent a at the point that the panel touches.
  const Ball& power() const { return power_; }
  static Ball rho(Ellipse ellipse) {
    return {std::array{Rational(16, 5), Rational(23, 5), Rational(5)}[static_cast<std::size_t>(ellipse)], 64};
  }
  /// Returns (A - 1) L/2.
  const Ball& reach(Ellipse ellipse) const { return bounds_[static_cast<std::size_t>(ellipse)].reach; }
  /// Returns the rule's error if |F| <= bound in the ellipse; not finite if a point of the set lies in it.
  Ball remainder(const Ball& bound, Ellipse ellipse) const {
    return bound * bounds_[static_cast<std::size_t>(ellipse)].remainder;
  }
  /// The same, where `bound` includes the powers of those points.
  Ball end_remainder(const Ball& bound, Ellipse ellipse) const {
    return bound * bounds_[static_cast<std::size_t>(ellipse)].end_remainder;
  }
  /// Adds term(node) for all nodes, which includes their weights, and the error bound of the rule.
  template <class Term>
  void add_sum(Ball& sum, const Term& term, const Ball& error) const {
    for (const Node& node : nodes_) sum += term(node);
    sum = Ball::plus_or_minus(sum, error);
  }
  /// Returns the largest product, in the ellipse, of the powers of the points that the panel does not touch.
  const Ball& largest_product(Ellipse ellipse) const { return bounds_[static_cast<std::size_t>(ellipse)].product; }
  /// Returns max |p(x)| in the ellipse, where x is the coordinate xi.
  Ball largest(const BallPolynomial& polynomial, Ellipse ellipse) const;

  /// Distances from one of a segment's points, from < to. The smaller one may be exactly 0.
  struct DistanceRange {
    Ball from;
    Ball to;
  };
  /// Returns panels that fill such a range, from left to right. The range must end before the segment's other point.
  /// Each panel is not longer than its distance from any point that it does not touch; the one that touches the point
  /// is also not longer than `first`.
  static std::vector<Interval> outward(const ContactSet& set, std::size_t segment, Side from,
                                       const DistanceRange& range, std::optional<Ball> first = std::nullopt);
  /// Returns a part divided into halves, repeatedly, until each is not longer than `longest` of it; undivided without
  /// `longest`.
  static std::vector<Interval> divided(Interval part, const std::function<Ball(const Interval&)>& longest);
  /// The same as outward(), for a segment, or for its left or right half.
  enum class Extent { whole, left_half, right_half };
  static std::vector<Interval> graded(const ContactSet& set, std::size_t segment, Extent extent = Extent::whole);

 private:
  struct Bounds {
    Ball reach;
    Ball product;
    Ball remainder;
    Ball end_remainder;
  };

  Interval part_;
  Ball power_;
  std::vector<Node> nodes_;
  std::array<Bounds, 3> bounds_;
  Ball farthest_;  ///< upper bound of |xi| on the panel
};

/// Returns 1/distance; not finite if the distance may be 0, so that it gives no bound.
Ball pole_bound(const Ball& distance);

}  // namespace steadyslide::enclosure
