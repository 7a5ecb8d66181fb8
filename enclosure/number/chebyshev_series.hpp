#pragma once
// A function f that is analytic around an interval, given by its values at Chebyshev's nodes t_i = cos((2 i + 1) pi/(2
// n)), i < n:
//
//   f(t) = sum_{j<n} c_j T_j(t) + e(t),  -1 <= t <= 1,   |e| <= 4 M rho^(1-n)/(rho-1) + (1 + (2/pi) log n) r.
//
// |f| <= M in Bernstein's ellipse rho > 1, so the Chebyshev coefficients of f are at most 2 M rho^-k. At the nodes each
// T_k with k >= n is 0 or, up to its sign, one of the first n; so its coefficient counts twice in the error: it is
// missing, and it is added there. The midpoints of balls are interpolated; r is their largest radius, and its factor
// bounds Lebesgue's constant [Trefethen, Approximation Theory and Approximation Practice, theorems 8.1, 4.2, 15.2].

#include <vector>

#include "enclosure/number/ball.hpp"

namespace steadyslide::enclosure {

class ChebyshevNodes {
 public:
  ChebyshevNodes(int count, Bits bits);

  int count() const { return count_; }
  Bits bits() const { return bits_; }
  /// Returns t_i, decreasing from 1 to -1.
  const Ball& operator[](int i) const { return cosine(2 * i + 1); }
  /// Returns T_j(t_i).
  const Ball& polynomial(int j, int i) const { return cosine(j * (2 * i + 1)); }

 private:
  /// Returns cos(k pi/(2 n)).
  const Ball& cosine(int k) const { return cosines_[static_cast<std::size_t>(k % (4 * count_))]; }

  int count_;
  Bits bits_;
  std::vector<Ball> cosines_;
};

class ChebyshevSeries {
 public:
  /// Takes the values of f at the nodes. The nodes must outlive the series. |f| <= bound in the ellipse rho.
  ChebyshevSeries(const ChebyshevNodes& nodes, const std::vector<Ball>& values, const Ball& bound, const Ball& rho);

  /// Returns f(t) for all t in [-1, 1].
  Ball range() const;
  /// Returns f(t), |t| <= 1.
  Ball at(const Ball& t) const;
  /// Returns f on a part [from, to] of [-1, 1], with its own t.
  ChebyshevSeries restricted(const Ball& from, const Ball& to) const;

 private:
  ChebyshevSeries(const ChebyshevNodes& nodes, const std::vector<Ball>& values, Ball error);
  Ball polynomial_at(const Ball& t) const;

  const ChebyshevNodes* nodes_;
  std::vector<Ball> coefficients_;
  Ball error_;
};

}  // namespace steadyslide::enclosure
