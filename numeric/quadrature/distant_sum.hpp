#pragma once
// The sum sum_i f_i/(x + y_i), y_i in [0, 1], for many x >= 1/2, in higher precision than double. With z = 1 + 2 x,
// Chebyshev's polynomials T_k and rho = z + sqrt(z^2 - 1) >= 3.7,
//
//   1/(x + y) = 2/sqrt(x (1 + x)) (1/2 + sum_{k>0} rho^-k T_k(1 - 2 y)),
//
// so the moments m_k = sum_i f_i T_k(1 - 2 y_i) are sufficient. Each term costs a product instead of a quotient, and
// larger x need fewer terms. From the other end (1 - y in place of y) the signs of the odd moments change.

#include <algorithm>
#include <cmath>
#include <vector>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <Real R>
class DistantSum {
 public:
  DistantSum() = default;
  /// `y` and `f` have the same length.
  DistantSum(const std::vector<R>& y, const R* f) : moments_(terms(R(0.5), digits), R(0)) {
    for (std::size_t i = 0; i < y.size(); ++i) {
      size_ += std::abs(static_cast<double>(f[i]));
      const R twice = 2 - 4 * y[i];
      R now = f[i];
      R other = now * twice / 2;
      R next;
      for (R& moment : moments_) {
        moment += now;
        next = twice;
        next *= now;
        next -= other;
        other = now;
        now = next;
      }
    }
    moments_[0] /= 2;
    for (const R& moment : moments_) rough_.push_back(static_cast<double>(moment));
  }

  /// Returns the sum at the distance x from y = 0, or from y = 1 if `beyond_one`.
  R value(const R& x, bool beyond_one) const {
    const R root = sqrt(R(x * (1 + x)));
    const R rho = 1 + 2 * (x + root);
    const R q = beyond_one ? R(-1 / rho) : R(1 / rho);
    // Double is sufficient for terms in which rho^-k is so small that only double's digits matter.
    const std::size_t last = std::min(terms(x, digits), moments_.size());
    const std::size_t first = std::min(terms(x, beyond_double), last);
    const auto rough_q = static_cast<double>(q);
    double rough = 0;
    for (std::size_t k = last; k-- > first;) rough = rough * rough_q + rough_[k];
    R sum = rough;
    for (std::size_t k = first; k-- > 0;) {
      sum *= q;
      sum += moments_[k];
    }
    return 2 * sum / root;
  }
  /// Returns sum_i |f_i|.
  double size() const { return size_; }

  /// Returns the number of terms until rho^-k is far below e^-accuracy.
  static std::size_t terms(const R& x, double accuracy) {
    const auto d = static_cast<double>(x);
    return static_cast<std::size_t>((accuracy + 2) / std::log1p(2 * (d + std::sqrt(d * (1 + d))))) + 2;
  }
  /// -log(epsilon), and the part of it that exceeds the precision of double.
  inline static const double digits = -std::log(static_cast<double>(epsilon<R>()));
  inline static const double beyond_double = digits + std::log(epsilon<double>());

 private:
  std::vector<R> moments_;
  std::vector<double> rough_;  ///< the same
  double size_ = 0;
};

}  // namespace steadyslide::numeric
