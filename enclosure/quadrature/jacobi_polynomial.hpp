#pragma once
// The monic Jacobi polynomial P of degree n for the weight (1+x)^l (1-x)^r on [-1, 1], with exact l and r > -1, and its
// proved zeros. P_0 = 1, P_{k+1} = (x - a_k) P_k - b_k P_{k-1} [DLMF 18.9],
//
//   a_k = (l^2 - r^2)/((s + 2k)(s + 2k + 2)),   b_k = 4k (k+l)(k+r)(k+s)/((2k+s)^2 (2k+s+1)(2k+s-1)),   s = l + r.
//
// A zero. P and P' are enclosed once, at an exact place x_0 next to the zero. The differential equation
//   (1-x^2) P'' + (l - r - (s+2) x) P' + n (n+s+1) P = 0
// gives Taylor's coefficients c_k at x_0: with u = 1 - x_0^2 and e = l - r - (s+2) x_0,
//   u (k+2)(k+1) c_{k+2} = (2k x_0 - e)(k+1) c_{k+1} - (n (n+s+1) - k (k+s+1)) c_k.
// Here |2k x_0 - e|/(k+2) <= max(2, |e|), and the last bracket lies between 0 and n (n+s+1) for k <= n; c_k = 0 beyond.
// By induction |c_k| <= C t^k with
//   t = max(2 max(2, |e|)/u, sqrt(n (n+s+1)/u)),   C = max(|c_0|, |c_1|/t),
// so for |x - x_0| <= R and q = t R < 1, the terms beyond degree m are at most C q^(m+1)/(1-q) in P and C t (m+1)
// q^m/(1-q)^2 in P', and |P''| <= 2 C t^2/(1-q)^3. The interval D = d +- r around an approximate root of Taylor's
// polynomial then holds exactly one zero of P, and it lies in N = d - P(x_0 + d)/P'(D), if N lies inside D: interval
// Newton.

#include <optional>
#include <vector>

#include "enclosure/number/ball.hpp"
#include "model/direction.hpp"

namespace steadyslide::enclosure {

/// Bounds for a power series sum_k c_k d^k with |c_k| <= C t^k, at |d| <= R with q = t R < 1.
struct TaylorRest {
  Ball value;      ///< of the terms beyond degree m
  Ball slope;      ///< of their derivative
  Ball curvature;  ///< of the second derivative of the whole series
};
TaylorRest taylor_rest(const Ball& size, const Ball& t, const Ball& q, int degree);

class JacobiPolynomial {
 public:
  struct Zero {
    Ball distance;  ///< from the end of [-1, 1] on the given side
    Ball slope;     ///< P' there
  };

  /// Computes with `bits`. l = left, r = right: exact balls.
  JacobiPolynomial(int count, const Ball& left, const Ball& right, Bits bits);

  /// Returns the only zero in a small neighbourhood of -1 + start (Side::left) or 1 - start (Side::right),
  /// 0 < start < 2. Absent if it was not proved, because the start was too far away or there are too few bits.
  std::optional<Zero> zero_near(double start, Side side) const;

  /// Returns b_1 ... b_n (2n + s + 1). The rule's weights are this times int (1+x)^l (1-x)^r dx/((1 - x_i^2)
  /// P'(x_i)^2).
  const Ball& norm() const { return norm_; }

 private:
  struct Pair {
    Ball p;
    Ball before;  ///< P_{n-1}
  };

  Pair at(const Ball& x) const;

  int count_;
  Bits bits_;
  Ball left_;
  Ball right_;
  Ball sum_;
  Ball eigenvalue_;             ///< n (n+s+1)
  std::vector<Ball> centres_;   ///< a_k
  std::vector<Ball> products_;  ///< b_k; the first one is not used
  Ball norm_;
};

}  // namespace steadyslide::enclosure
