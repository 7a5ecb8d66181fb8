#pragma once
// The piecewise cubic through given points that is monotone where they are, with a continuous derivative [Fritsch and
// Carlson, SIAM J. Numer. Anal. 17 (1980) 238].

#include <algorithm>
#include <vector>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <Real R>
class MonotoneCubic {
 public:
  /// Takes at least three places, increasing.
  MonotoneCubic(std::vector<R> places, std::vector<R> values) : x_(std::move(places)), y_(std::move(values)) {
    const auto length = [&](std::size_t k) { return R(x_[k + 1] - x_[k]); };
    const auto secant = [&](std::size_t k) { return R((y_[k + 1] - y_[k]) / length(k)); };
    const std::size_t last = x_.size() - 1;
    slope_.push_back(secant(0));
    for (std::size_t k = 1; k < last; ++k) {
      const R s = secant(k - 1);
      const R t = secant(k);
      const R v = length(k - 1) + 2 * length(k);
      const R w = length(k) + 2 * length(k - 1);
      slope_.push_back(s * t > 0 ? R((v + w) / (v / s + w / t)) : R(0));
    }
    slope_.push_back(secant(last - 1));
  }

  /// Takes x from the first place to the last one.
  R at(const R& x) const {
    const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
    const auto k = static_cast<std::size_t>(above - x_.begin()) - 1;
    const R length = x_[k + 1] - x_[k];
    const R u = (x - x_[k]) / length;
    const R v = 1 - u;
    return v * v * ((1 + 2 * u) * y_[k] + u * length * slope_[k]) +
           u * u * ((1 + 2 * v) * y_[k + 1] - v * length * slope_[k + 1]);
  }

 private:
  std::vector<R> x_;
  std::vector<R> y_;
  std::vector<R> slope_;
};

}  // namespace steadyslide::numeric
