#pragma once
// Chebyshev's points of the first kind on [-1, 1], the series through values there, and sums of series.

#include <vector>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

/// Returns sum_m c_m T_m(v) by Clenshaw's recurrence, -1 <= v <= 1. There is at least one coefficient.
template <Real R>
R chebyshev_sum(const std::vector<R>& series, const R& v) {
  R last = 0, before = 0;
  for (std::size_t m = series.size(); m-- > 1;) {
    const R next = 2 * v * last - before + series[m];
    before = last;
    last = next;
  }
  return v * last - before + series[0];
}

template <Real R>
class ChebyshevPoints {
 public:
  explicit ChebyshevPoints(std::size_t n) : n_(n) {
    for (std::size_t k = 0; k < 4 * n; ++k) {
      cosines_.push_back(cos(R(pi<R>() * static_cast<int>(k) / (2 * static_cast<int>(n)))));
    }
  }

  std::size_t size() const { return n_; }
  R place(std::size_t k) const { return cosines_[2 * k + 1]; }
  /// Returns the coefficients of T_0, T_1, ... through values at all places.
  std::vector<R> series(const std::vector<R>& values) const {
    std::vector<R> result;
    for (std::size_t m = 0; m < n_; ++m) {
      R sum = 0;
      for (std::size_t k = 0; k < n_; ++k) sum += values[k] * cosines_[m * (2 * k + 1) % (4 * n_)];
      result.push_back(sum * (m == 0 ? 1 : 2) / static_cast<int>(n_));
    }
    return result;
  }

 private:
  std::size_t n_;
  std::vector<R> cosines_;  ///< of pi k/(2n), k = 0..4n-1
};

}  // namespace steadyslide::numeric
