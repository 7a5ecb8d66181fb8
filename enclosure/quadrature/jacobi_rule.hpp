#pragma once
// The Gauss-Jacobi rule with n nodes on [-1, 1], enclosed: for left, right > -1 and f analytic,
//
//   int_{-1}^{1} (1+x)^left (1-x)^right f(x) dx = sum_i w_i f(x_i) + R.
//
// The powers may be thin balls [l +- dl], [r +- dr]. Nodes x_i and weights w_i belong to the midpoints l and r, exact
// numbers: x_i are the zeros of P_n^(r,l), proved one by one (jacobi_polynomial.hpp). There are n disjoint balls, so
// they contain all zeros.
//
//   w_i = mu_0 b_1 ... b_n (2n+l+r+1)/((1 - x_i^2) P'(x_i)^2)  for the monic polynomial P and the weight's mass mu_0 (mass).
//
// Remainder. Let |f| <= M in the closed ellipse with foci -1, 1 and semi-axes (rho + 1/rho)/2 and (rho - 1/rho)/2,
// rho > 1 (Bernstein), f analytic there. Then f = sum_k a_k T_k with |a_k| <= 2 M rho^-k. The rule is exact for k < 2n,
// and as |T_k| <= 1 on [-1, 1] and weights are positive with sum mu_0, each later T_k is wrong by at most 2 mu_0:
//
//   |R| <= 2 mu_0 sum_{k >= 2n} 2 M rho^-k = 4 mu_0 M rho^(1-2n)/(rho - 1).
//
// The effect of the powers' radii: |d/dleft int| <= M int |log(1+x)| (1+x)^left (1-x)^right dx, and with y = (1+x)/2,
// |log(1+x)| <= log 2 - log y, int (-log y) (1+x)^left (1-x)^right dx = mass (psi(left+right+2) - psi(left+1)), psi the
// digamma function; by the mean value theorem R grows by at most M spread,
//
//   spread = mass (dl (log 2 + psi(left+right+2) - psi(left+1)) + dr (log 2 + psi(left+right+2) - psi(right+1))).

#include <cstddef>
#include <map>
#include <mutex>
#include <vector>

#include "enclosure/number/ball.hpp"

namespace steadyslide::enclosure {

class JacobiRule {
 public:
  /// Throws std::invalid_argument unless count >= 1 and both powers are certainly > -1, std::runtime_error if a node is
  /// not proved. Distances and weights have a relative accuracy of about 2^-bits.
  JacobiRule(int count, const Ball& left, const Ball& right, Bits bits);

  std::size_t size() const { return weights.size(); }

  /// Returns |R| for |f| <= bound in the ellipse rho. Not finite unless rho is certainly > 1.
  Ball remainder(const Ball& bound, const Ball& rho) const;
  /// Returns |R| for a polynomial f of degree < 2n, |f| <= bound on [-1, 1]; 0 if the powers are exact.
  Ball remainder(const Ball& bound) const;

  std::vector<Ball> from_left;   ///< 1 + x_i, increasing
  std::vector<Ball> from_right;  ///< 1 - x_i
  std::vector<Ball> weights;
  Ball mass;  ///< int (1+x)^left (1-x)^right dx

 private:
  /// Returns false if a node was not proved with this number of bits.
  bool make(int count, const Ball& left, const Ball& right, Bits bits, Bits working);
  void make_legendre(int count, Bits bits);
  bool is_proved(Bits bits) const;

  Ball spread_;
};

/// A cache of rules by number of nodes and pair of powers. Two balls are the same key only if midpoint and radius are
/// equal. Threads may share it.
class JacobiRules {
 public:
  explicit JacobiRules(Bits bits) : bits_(bits) {}

  Bits bits() const { return bits_; }
  std::size_t size() const { return rules_.size(); }

  /// Returns the rule. The reference is valid as long as this object exists. Throws as JacobiRule does.
  const JacobiRule& operator()(int count, const Ball& left, const Ball& right);

 private:
  struct Key {
    int count;
    Ball left;
    Ball right;
  };
  struct Before {
    bool operator()(const Key& a, const Key& b) const;
  };

  Bits bits_;
  std::map<Key, JacobiRule, Before> rules_;
  std::mutex in_use_;
};

}  // namespace steadyslide::enclosure
