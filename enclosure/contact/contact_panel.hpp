#pragma once
// A Gauss-Jacobi rule for int F |Y|^n dx over a panel, a part of a segment of the contact set which touches one of the
// segment's points at most: n = 1 or -1, and |Y| is a product of powers of distances to the set's points, one of which
// may be lowered by one more. With the panel's length L, the power a of the point that it touches (0 if none) and F
// analytic and |F| <= M in the panel's Bernstein ellipse rho > 1, the rule of N nodes errs by no more than
//
//   4 mu (L/2)^(a+1) M Q rho^(1-2N)/(rho-1),   mu = int_{-1}^{1} (1+x)^a dx,
//
// Q the largest product of the other powers on the ellipse. The ellipse reaches L/2 beyond both ends of the panel,
// A = (rho + 1/rho)/2, so that a distance D from an end lies between D - (A-1) L/2 and D + L + (A-1) L/2 on it. Three
// ellipses serve: panels are no longer than their distance from points that they do not touch. Bounds have 64 bits.

#include <array>
#include <functional>
#include <vector>

#include "enclosure/contact/contact_set.hpp"
#include "enclosure/number/ball_polynomial.hpp"
#include "enclosure/quadrature/jacobi_rule.hpp"

namespace steadyslide::enclosure {

/// rho = 16/5, 23/5, 5: it reaches 0.38, 0.7, 0.8 of the panel's length beyond both ends.
enum class Ellipse { close, beside, far };

class ContactPanel {
 public:
  struct Part {
    std::size_t segment;
    Ball from_left;   ///< of the panel's left end from the segment's left point; exactly 0 where it touches it
    Ball from_right;  ///< of the panel's right end from the segment's right point
    Ball length;
    std::optional<Side> touches;
  };
  struct Node {
    Ball from_left;  ///< distances from the segment's two points
    Ball from_right;
    Ball weight;
    Ball end_weight;  ///< without the powers of the points that the panel does not touch
  };

  /// `lowered`: the point whose power is one less than in |Y|^n.
  ContactPanel(const ContactSet& set, Part part, int n, std::optional<std::size_t> lowered, int count,
               JacobiRules& rules);

  const Part& part() const { return part_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  /// The exponent a at the point that the panel touches.
  const Ball& power() const { return power_; }
  static Ball rho(Ellipse ellipse) {
    return {std::array{Rational(16, 5), Rational(23, 5), Rational(5)}[static_cast<std::size_t>(ellipse)], 64};
  }
  /// (A - 1) L/2.
  const Ball& reach(Ellipse ellipse) const { return bounds_[static_cast<std::size_t>(ellipse)].reach; }
  /// The rule's error if |F| <= bound in the ellipse; not finite if a point of the set lies in it.
  Ball remainder(const Ball& bound, Ellipse ellipse) const {
    return bound * bounds_[static_cast<std::size_t>(ellipse)].remainder;
  }
  /// The same where the bound is one on F and those powers together.
  Ball end_remainder(const Ball& bound, Ellipse ellipse) const {
    return bound * bounds_[static_cast<std::size_t>(ellipse)].end_remainder;
  }
  /// Adds term(node) for all nodes, which includes their weights, and what the rule errs by at most.
  template <class Term>
  void add_sum(Ball& sum, const Term& term, const Ball& error) const {
    for (const Node& node : nodes_) sum += term(node);
    sum = Ball::plus_or_minus(sum, error);
  }
  /// The largest product of the powers of the points that the panel does not touch, in the ellipse.
  const Ball& largest_product(Ellipse ellipse) const { return bounds_[static_cast<std::size_t>(ellipse)].product; }
  /// max |p(x)| in the ellipse, x the coordinate xi.
  Ball largest(const BallPolynomial& polynomial, Ellipse ellipse) const;

  /// Distances from one of a segment's points, from < to; the smaller one may be 0 exactly.
  struct Range {
    Ball from;
    Ball to;
  };
  /// Panels that fill such a range, which ends before the segment's other point, from left to right: each is no longer than
  /// its distance from any point that it does not touch, the one that touches the point no longer than `first` either.
  static std::vector<Part> outward(const ContactSet& set, std::size_t segment, Side from, const Range& range,
                                   std::optional<Ball> first = std::nullopt);
  /// A part in halves, and these in halves, until each is no longer than `longest` says of it; whole without that.
  static std::vector<Part> divided(Part part, const std::function<Ball(const Part&)>& longest);
  /// The same as outward() for a segment, or its left or right half.
  enum class Extent { whole, left_half, right_half };
  static std::vector<Part> graded(const ContactSet& set, std::size_t segment, Extent extent = Extent::whole);

 private:
  struct Bounds {
    Ball reach;
    Ball product;
    Ball remainder;
    Ball end_remainder;
  };

  Part part_;
  Ball power_;
  std::vector<Node> nodes_;
  std::array<Bounds, 3> bounds_;
  Ball farthest_;  ///< |xi| on the panel is no larger
};

/// 1/distance; not finite where the distance may be 0, so that no bound is made of it.
Ball pole_bound(const Ball& distance);

}  // namespace steadyslide::enclosure
