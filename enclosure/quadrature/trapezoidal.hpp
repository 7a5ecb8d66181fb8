#pragma once
// An independent check of Gauss-Jacobi panels without common code: the trapezoidal rule in tau with all its errors, for
//
//   int_0^L y^left (L-y)^right W(y) F(y) dy  or, with a pole p inside, the principal value of  .../(y - p),
//   W = prod_j (distance to the outside point j)^(power_j),   left, right > -1,
//
// y = L/(1+e^-tau), L - y = L/(1+e^tau), dy = L dtau/((1+e^-tau)(1+e^tau)). The integrand becomes
//   G(tau) = L^(left+right+1) (1+e^-tau)^-(left+1) (1+e^tau)^-(right+1) W F,
// and singular places on the real axis outside the panel have |Im tau| = pi, also if they are close to an end.
//
// Discretisation. Let G be analytic for |Im tau| <= d except for a simple pole at a real tau_p, with nodes
// tau_k = tau_p + (k+1/2) h (if there is no pole, any tau_p). In h sum G(tau_k) = (1/2i) (int_{Im=-d} - int_{Im=+d}) G
// cot(pi (tau - tau_p - h/2)/h) dtau the pole adds nothing: cot(-pi/2) = 0. On the upper line cot w = -i - 2i
// e^(2iw)/(1 - e^(2iw)), on the lower one its conjugate; the principal value is the mean of both lines' integrals. So
//   |PV int G - h sum G(tau_k)| <= N/(e^(2 pi d/h) - 1),   N = int |G(t+id)| + |G(t-id)| dt.
// N. |a + b e^(i theta)| >= (a+b) cos(theta/2) for a, b >= 0: with k = cos(d/2), |1 + e^-+tau| on the lines lies
// between k and 1 times its value at t = Re tau, and a distance ((L+d_j) + d_j e^-tau)/(1+e^-tau) between k and 1/k
// times its own. Likewise |1/(y-p)| <= max(1/p, 1/(L-p))/sin(d/2) =: Q there. Let |F| <= M in the lens, the image of
// the strip, and W <= W_max on the panel:
//   N <= 2 k^-(left + right + 2 + sum |power_j|) L^(left+right+1) B(left+1, right+1) W_max M Q   (Q = 1 without a pole).
// Omitted nodes: with tau_o the first one of them, the nodes below add, in a geometric series, at most
//   h L^(left+right+1) W_max M Q_o e^((left+1) tau_o)/(1 - e^-(left+1)h),   Q_o = 1/(p - y(tau_o)),
// and the nodes above similarly.
// The lens lies in the disc around the panel's middle with the radius (L/2) tan(d/2), for d >= pi/2.

#include <optional>
#include <vector>

#include "enclosure/number/ball.hpp"
#include "enclosure/quadrature/outside_points.hpp"

namespace steadyslide::enclosure {

class Trapezoidal {
 public:
  struct Node {
    Ball from_left;
    Ball from_right;
    Ball weight;  ///< everything but F
  };
  struct Pole {
    Ball from_left;
    Ball from_right;
  };

  /// Uses the number of nodes for an accuracy of about 2^-bits, up to 10^6 on each side, if F does not grow faster in
  /// the lens than a polynomial of this degree.
  /// Throws std::invalid_argument unless both powers are certainly > -1 and every length and distance is certainly > 0.
  Trapezoidal(const Ball& length, const Ball& left, const Ball& right, const std::vector<OutsidePoint>& outside,
              const std::optional<Pole>& pole, int degree, Bits bits);

  const std::vector<Node>& nodes() const { return nodes_; }
  /// Returns the radius of a disc around the panel's middle that contains the lens.
  const Ball& lens_radius() const { return lens_radius_; }

  /// Returns a bound of |int - sum weight F(node)| for |F| <= bound_of_F in the lens.
  Ball remainder(const Ball& bound_of_F) const { return remainder_ * bound_of_F; }

  /// Returns the integral. F takes a Node and returns a Ball.
  template <class F>
  Ball integral(const F& f, const Ball& bound_of_F) const {
    Ball sum(0, bits_);
    for (const Node& node : nodes_) sum += node.weight * f(node);
    return Ball::plus_or_minus(sum, remainder(bound_of_F));
  }

 private:
  Bits bits_;
  Ball lens_radius_;
  Ball remainder_;
  std::vector<Node> nodes_;
};

}  // namespace steadyslide::enclosure
