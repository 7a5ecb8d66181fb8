#pragma once
// Integrals over one panel [0, L], y from its left end, with powers at its ends and at places outside:
//
//   int_0^L y^left (L-y)^right W(y) F(y) dy,   W = prod_j (distance to the outside point j)^(power_j),
//
// left, right > -1, F analytic. With y = L (1+x)/2 this is (L/2)^(left+right+1) int (1+x)^left (1-x)^right W F dx, by
// the Gauss-Jacobi rule with its remainder (jacobi_rule.hpp) in an ellipse rho, whose image has the foci 0 and L and
// reaches
//
//   reach = (L/2) ((rho + 1/rho)/2 - 1)
//
// beyond each end. W is analytic there if every outside point is farther away than this. rho is chosen, in double,
// where the bound of the remainder is smallest for constant F.

#include <cmath>
#include <vector>

#include "enclosure/number/ball.hpp"
#include "enclosure/quadrature/jacobi_rule.hpp"
#include "enclosure/quadrature/outside_points.hpp"

namespace steadyslide::enclosure {

class PowerPanel {
 public:
  struct Node {
    Ball from_left;
    Ball from_right;
    Ball weight;  ///< everything but F
  };
  /// The largest rho. If there is no outside point, any ellipse would be possible, but F may grow in a larger one.
  static constexpr double largest_rho = 64;

  /// Throws as JacobiRule does. If a distance or the length is not certainly positive, remainders are not finite.
  PowerPanel(const Ball& length, const Ball& left, const Ball& right, std::vector<OutsidePoint> outside, int count,
             JacobiRules& rules);

  /// Returns the number of nodes for which 4 rho^(1-2n)/(rho-1) <= 2^-bits.
  static int count_for(Bits bits, double rho);
  /// Returns the number of nodes for which the remainder for constant F is below 2^-bits of the largest value on the
  /// panel times the weight's mass. Returns 0 if an outside point is so near that no number below 100000 is sufficient.
  static int count_for(Bits bits, const Ball& length, const std::vector<OutsidePoint>& outside);

  const Ball& length() const { return length_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const Ball& rho() const { return rho_; }
  /// Returns the reach of the ellipse beyond each end.
  const Ball& reach() const { return reach_; }

  /// Returns a bound of |int - sum weight F(node)| for |F| <= bound_of_F in the ellipse.
  Ball remainder(const Ball& bound_of_F) const { return remainder_ * bound_of_F; }
  /// The same for the principal value of F/(y - L/2): |F| <= bound_of_F, and the number of nodes is even. The bound of
  /// the difference quotient is in enclosed_integral.hpp.
  Ball remainder_of_principal_value(const Ball& bound_of_F) const;
  /// The same for a polynomial F of degree < 2 count without outside points, |F| <= bound_of_F on the panel.
  Ball remainder_of_polynomial(const Ball& bound_of_F) const { return polynomial_remainder_ * bound_of_F; }

  /// Returns the integral. F takes a Node and returns a Ball.
  template <class F>
  Ball integral(const F& f, const Ball& bound_of_F) const {
    return sum(f, remainder(bound_of_F));
  }
  /// Returns the integral with another remainder.
  template <class F>
  Ball sum(const F& f, const Ball& remainder) const {
    Ball sum(0, length_.bits());
    for (const Node& node : nodes_) sum += node.weight * f(node);
    return Ball::plus_or_minus(sum, remainder);
  }

 private:
  Ball length_;
  Ball rho_;
  Ball reach_;
  Ball remainder_;
  Ball polynomial_remainder_;
  std::vector<Node> nodes_;
};

}  // namespace steadyslide::enclosure
