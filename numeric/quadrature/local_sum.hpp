#pragma once
// The sum sum_i f_i/(x_i - y) for many y in [0, 1] and sources at distances d_i >= 1/2 from the nearer end of [0, 1],
// in higher precision than double. With rho of distant_sum.hpp,
//
//   1/(d + y) = 2/sqrt(d (1 + d)) (1/2 + sum_{k>0} rho^-k T_k(1 - 2 y)),
//
// all sources together are one series of Chebyshev's polynomials. The cost of a place is the number of terms, for any
// number of sources.

#include "numeric/quadrature/distant_sum.hpp"

namespace steadyslide::numeric {

template <Real R>
class LocalSum {
 public:
  /// Adds a source at the distance d beyond y = 1 if it is on the right; otherwise beyond y = 0.
  void add(const R& f, const R& d, bool is_right) {
    const R root = sqrt(R(d * (1 + d)));
    R q = 1 / (1 + 2 * (d + root));
    R term = f / root;
    (is_right ? q : term) *= -1;
    const std::size_t count = DistantSum<R>::terms(d, DistantSum<R>::digits);
    const std::size_t first = std::min(DistantSum<R>::terms(d, DistantSum<R>::beyond_double), count);
    if (terms_.size() < first) terms_.resize(first, R(0));
    if (rough_.size() < count) rough_.resize(count, 0);
    for (std::size_t k = 0; k < first; ++k) {
      terms_[k] += term;
      if (k == 0) term *= 2;
      term *= q;
    }
    // The remaining terms are so small that double is sufficient.
    auto rough = static_cast<double>(term);
    const auto rough_q = static_cast<double>(q);
    for (std::size_t k = first; k < count; ++k, rough *= rough_q) rough_[k] += rough;
    size_ += abs(static_cast<double>(f)) / static_cast<double>(d);
  }

  R value(const R& y) const {
    const R twice = 2 - 4 * y;
    return clenshaw(terms_, twice) + clenshaw(rough_, static_cast<double>(twice));
  }
  /// Returns sum_i |f_i|/d_i, an upper bound of the sum of absolute values at any place.
  double size() const { return size_; }

 private:
  /// Returns sum_k a_k T_k(twice/2).
  template <class Number>
  static Number clenshaw(const std::vector<Number>& a, const Number& twice) {
    Number now = 0, before = 0, next;
    for (std::size_t k = a.size(); k-- > 1;) {
      next = twice;
      next *= now;
      next -= before;
      next += a[k];
      before = now;
      now = next;
    }
    return a.empty() ? Number(0) : Number(a[0] + twice * now / 2 - before);
  }

  std::vector<R> terms_;
  std::vector<double> rough_;
  double size_ = 0;
};

}  // namespace steadyslide::numeric
