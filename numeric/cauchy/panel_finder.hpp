#pragma once
// Finds the panel that contains a point x of the surface, and the distances of x from the ends of the panel.
//
// An end e is kept as two numbers, e = high + low, low = e - high rounded. (x - high) - low is x - e with a relative
// error of at most eps(R), the distance from 1 to the next number, however close x is to e. If x and high have similar
// size, x - high is exact; then low, which is below |x - e| unless x = high, is correct to half a unit. In a unit that
// is not a power of two, distances have twice that error.

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <Real R>
class PanelFinder {
 public:
  /// Takes the ends of the panels, from left to right, in the user's x. Distances are returned in `unit`.
  PanelFinder(const std::vector<Rational>& ends, const Rational& unit) : per_unit_(to_real<R>(1 / unit)) {
    for (const Rational& end : ends) {
      high_.push_back(to_real<R>(end));
      low_.push_back(to_real<R>(end - Rational(high_.back())));
    }
  }

  /// Calls inside(panel, first, from_left, from_right) for points x[first], x[first + 1], ... of one panel. Calls
  /// at_end(i) if x[i] is an end, or so close to one that the distance underflows. Skips points beyond all panels.
  /// Consecutive points of one panel are passed in one call, so sorted points cost least.
  template <class Inside, class AtEnd>
  void visit(std::span<const R> x, const Inside& inside, const AtEnd& at_end) const {
    constexpr std::size_t most = 256;
    R from_left[most];
    R from_right[most];
    const R least = (std::numeric_limits<R>::min)();
    for (std::size_t first = 0; first < x.size();) {
      const std::size_t panel = panel_of(x[first]);
      if (panel + 1 >= high_.size()) {
        ++first;
        continue;
      }
      const std::size_t count = std::min(most, x.size() - first);
      for (std::size_t i = 0; i < count; ++i) {
        from_left[i] = distance(x[first + i], panel) * per_unit_;
        from_right[i] = -distance(x[first + i], panel + 1) * per_unit_;
      }
      std::size_t n = 0;
      while (n < count && from_left[n] >= least && from_right[n] >= least) ++n;
      if (n > 0) {
        inside(panel, first, std::span<const R>(from_left, n), std::span<const R>(from_right, n));
        first += n;
      } else {
        at_end(first);
        ++first;
      }
    }
  }

 private:
  /// Returns x - e.
  R distance(const R& x, std::size_t end) const { return (x - high_[end]) - low_[end]; }

  /// Returns k with e_k <= x < e_{k+1}; for the last end, the last panel. Outside all panels the result is at least the
  /// number of panels.
  std::size_t panel_of(const R& x) const {
    auto k = static_cast<std::size_t>(std::upper_bound(high_.begin(), high_.end(), x) - high_.begin());
    if (k < high_.size() && distance(x, k) >= 0) ++k;
    if (k > 0 && distance(x, k - 1) < 0) --k;
    if (k == 0) return high_.size();
    if (k == high_.size() && distance(x, k - 1) == 0) --k;
    return k - 1;
  }

  std::vector<R> high_;
  std::vector<R> low_;
  R per_unit_;
};

}  // namespace steadyslide::numeric
