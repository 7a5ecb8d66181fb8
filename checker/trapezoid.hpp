#pragma once
// An enclosed quadrature for products of powers, by the trapezoidal rule in tau, x = tanh(tau/2).
//
// On a panel [a, b] of length L let w(x) = prod_j |x - e_j|^(c_j) with all e_j real and none inside. Points at a and b
// are allowed, with powers c > -1. With x = a + L/(1 + e^-tau) the distances to the ends are u = L/(1 + e^-tau),
// v = L/(1 + e^tau), dx = (u v/L) dtau, and F(tau) = w u v/L is analytic for |Im tau| < pi: the real line outside the
// panel is Im tau = +-pi. So panels need no grading, even if another singular point is very close.
//
// For |Im tau| <= d < pi and rho >= 0 one has cos(d/2) (1 + rho) <= |1 + rho e^(i phi)| <= 1 + rho, |phi| <= d. So
// |u|, |v| and all |x - e_j| are those at t = Re tau up to the factor sec(d/2): between 1 and sec(d/2) times for u and
// v, between cos(d/2) and sec(d/2) times for |x - e_j|. Hence
//   |F(t + i y)| <= sec(d/2)^kappa F(t),  kappa = sum |c_j| + 2 (c + 1 for a power at an end),
// and the trapezoidal rule with step h, |int F - h sum F(k h)| <= int |F(t+id)| + |F(t-id)| dt/(e^(2 pi d/h) - 1), errs
// by
//   2 sec(d/2)^kappa/(e^(2 pi d/h) - 1) int F:
// a relative error that is known before any node is computed. An analytic factor f of F with |f| <= M in the strip
// gives an error of at most 2 sec^kappa M/(e^(2 pi d/h) - 1) int F. A factor like 1/(x - x0), x0 real and outside,
// gives one more power of sec.
//
// Beyond the node at distance u_N from an end with the power c the nodes have u_k^(c+1) = (L/(1 + e_k))^(c+1)
// e_k^(c+1), e_k = e^-|tau_k|: the sum of e_k^(c+1) is geometric, and its factor lies in the range for 0 <= e <= e_N.
// So one more node with u = [0, u_N] and that sum as its weight represents all of them, and the sum of the rule is
// enclosed up to its end. The sum is short if u_N is small compared with the distances to all other points, even if the
// powers decrease slowly.

#include <array>
#include <vector>

#include "checker/ball.hpp"

namespace steadyslide::checker {

class Trapezoid {
 public:
  /// A power of the distances to points, which are given by their distance beyond a or b; 0 for a or b itself.
  struct Factor {
    Ball exponent;
    std::vector<Ball> left;
    std::vector<Ball> right;
  };
  struct Panel {
    Ball length;
    std::vector<Factor> factors;
    /// Poles 1/(x - x0) may be as close as these distances > 0 to the panel. They determine the range of the nodes.
    Ball left_reach;
    Ball right_reach;
    std::size_t degree = 0;  ///< largest degree of polynomial factors
  };
  struct Node {
    Ball u;  ///< from a
    Ball v;  ///< from b
    Ball weight;
    Bound above;   ///< bound of the weight
    Bound behind;  ///< bound of the sum of weights from this node outwards
  };

  /// Makes a rule with relative errors of about 2^-bits.
  Trapezoid(Panel panel, slong bits, slong precision);

  const Panel& panel() const { return panel_; }
  /// Returns the nodes from the middle to b, then from the middle to a. Each time the last node represents all nodes
  /// beyond.
  const std::vector<Node>& nodes() const { return nodes_; }
  std::size_t nodes_to_right() const { return nodes_to_right_; }
  const Ball& secant() const { return secant_; }  ///< sec(d/2)
  const Ball& kappa() const { return kappa_; }
  /// Returns 2 sec(d/2)^(kappa + more)/(e^(2 pi d/h) - 1), at most 1/2.
  const Ball& relative_error(int more) const { return relative_errors_.at(static_cast<std::size_t>(more)); }
  /// Returns an upper bound of int w f from its sum, for f > 0 of the form 1/|x - x0|^more, more <= 2.
  static Ball integral_bound(const Ball& sum) { return Ball(2) * sum.size(); }
  /// Returns the error of the rule for w f, where f is as above times an analytic factor of size M in the strip.
  Ball error(int more, const Ball& M, const Ball& sum) const {
    return M.size() * relative_error(more) * integral_bound(sum);
  }

 private:
  Panel panel_;
  Ball secant_;
  Ball kappa_;
  std::array<Ball, 3> relative_errors_;
  std::vector<Node> nodes_;
  std::size_t nodes_to_right_ = 0;
};

}  // namespace steadyslide::checker
