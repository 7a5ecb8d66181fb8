#pragma once
// The sum sum_i f_i/(x + y_i), x >= 0, for sources y_i > 0 and places x that extend over hundreds of octaves, in higher
// precision than double. The sum over panels of sources is
//
//   sum_j (-x)^j sum_i f_i y_i^-(j+1)          if y_i >= 8 x,
//   sum_j (-1)^j x^-(j+1) sum_i f_i y_i^j      if y_i <= x/8,
//
// The inner sums are computed once for every panel, over this and all following panels and over all panels before it.
// So the cost of a place is that of the panels at a similar distance, which the caller adds. The rest of a series is
// below epsilon/8 of the sum of its absolute values.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <Real R>
class GradedSum {
 public:
  struct Panel {
    R begin;  ///< y at its two ends
    R end;
    std::vector<R> y;  ///< y of its sources
    std::vector<R> f;
    std::vector<double> rounding = {};  ///< the errors of f that the sum of absolute values includes; empty: 0
  };
  GradedSum() = default;
  /// Takes the panels, which begin at y = 0.
  explicit GradedSum(std::vector<Panel> panels) : panels_(std::move(panels)), beyond_{{}}, before_{{}} {}

  struct Far {
    R value;
    double size;        ///< the sum of absolute values
    std::size_t first;  ///< panels first..end-1 are left out
    std::size_t end;
  };
  Far at(const R& x) {
    const R near = x / ratio;
    const R far = x * ratio;
    // Sources of the first panel can be arbitrarily close to a place at its end.
    const auto begin = panels_.begin();
    const auto first = std::partition_point(begin, panels_.end(), [&](const Panel& p) { return p.end <= near; });
    const auto end = std::partition_point(std::max(first, std::min(begin + 1, panels_.end())), panels_.end(),
                                          [&](const Panel& p) { return p.begin < far; });
    Far result{R(0), 0, static_cast<std::size_t>(first - begin), static_cast<std::size_t>(end - begin)};
    const auto add = [&result](const Series& series, const R& variable, const R& factor) {
      R sum = 0;
      for (std::size_t j = series.sums.size(); j-- > 0;) {
        sum *= variable;
        sum += series.sums[j];
      }
      result.value += factor * sum;
      result.size += static_cast<double>(factor) * series.size;
    };
    if (end != panels_.end()) add(beyond(panels_.size() - result.end), -x, R(1));
    if (result.first > 0) {
      const R inverse = 1 / x;
      add(before(result.first), -inverse, inverse);
    }
    return result;
  }

 private:
  static constexpr int ratio = 8;
  inline static const auto terms =
      static_cast<std::size_t>(-std::log(static_cast<double>(epsilon<R>())) / std::log(double(ratio))) + 2;

  struct Series {
    std::vector<R> sums = std::vector<R>(terms, R(0));
    double size = 0;

    void add(R term, const R& factor) {
      size += std::abs(static_cast<double>(term));
      for (R& sum : sums) {
        sum += term;
        term *= factor;
      }
    }
  };
  /// Returns sum f y^-(j+1) over the last `count` panels.
  const Series& beyond(std::size_t count) {
    while (beyond_.size() <= count) {
      const Panel& panel = panels_[panels_.size() - beyond_.size()];
      Series next = beyond_.back();
      for (std::size_t i = 0; i < panel.y.size(); ++i) {
        const R inverse = 1 / panel.y[i];
        next.add(panel.f[i] * inverse, inverse);
        if (!panel.rounding.empty()) next.size += panel.rounding[i] * static_cast<double>(inverse);
      }
      beyond_.push_back(std::move(next));
    }
    return beyond_[count];
  }
  /// Returns sum f y^j over the first `count` panels.
  const Series& before(std::size_t count) {
    while (before_.size() <= count) {
      const Panel& panel = panels_[before_.size() - 1];
      Series next = before_.back();
      for (std::size_t i = 0; i < panel.y.size(); ++i) next.add(panel.f[i], panel.y[i]);
      next.size = std::accumulate(panel.rounding.begin(), panel.rounding.end(), next.size);
      before_.push_back(std::move(next));
    }
    return before_[count];
  }

  std::vector<Panel> panels_;
  std::vector<Series> beyond_;  ///< computed on demand
  std::vector<Series> before_;
};

}  // namespace steadyslide::numeric
