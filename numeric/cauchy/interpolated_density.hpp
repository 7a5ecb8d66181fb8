#pragma once
// The smooth factor of a density, interpolated. For quadratures that need it at many points if it is itself an
// integral.
//
// The panel is divided into parts. A part is halved until the last coefficients of Chebyshev's series of degree n - 1
// show that the series is exact to rounding, or until halving no longer lowers them: then they come from the rounding
// of the factor. A part of 2^-12 of the panel that is still unresolved, next to a logarithm, keeps the factor itself.

#include <algorithm>
#include <cmath>
#include <memory>

#include "numeric/number/chebyshev.hpp"
#include "numeric/number/once.hpp"
#include "numeric/quadrature/density.hpp"

namespace steadyslide::numeric {

template <Real R>
class InterpolatedFactor {
 public:
  InterpolatedFactor(const Panel<R>& panel, std::function<R(const Node<R>&)> smooth)
      : panel_(panel), smooth_(std::move(smooth)) {}

  R operator()(const Node<R>& node) const {
    const R place = node.from_left / panel_.length;
    const std::vector<PanelInterval>& parts = parts_([this] { return resolved(); });
    const auto after = std::upper_bound(parts.begin(), parts.end(), place,
                                        [](const R& x, const PanelInterval& part) { return x < part.left; });
    const PanelInterval& part = after == parts.begin() ? *after : *(after - 1);
    if (part.series.empty()) return smooth_(node);
    return chebyshev_sum(part.series, R(2 * (place - part.left) / part.width - 1));
  }

 private:
  static constexpr int most_halvings = 12;
  static constexpr std::size_t nodes = std::same_as<R, double> ? 16 : std::same_as<R, Real50> ? 40 : 72;

  /// In units of the panel length.
  struct PanelInterval {
    R left;
    R width;
    std::vector<R> series;  ///< empty: the factor itself
  };

  std::vector<PanelInterval> resolved() const {
    const ChebyshevPoints<R> points(nodes);
    std::vector<PanelInterval> result;
    resolve(R(0), R(1), 0, infinity<R>(), points, result);
    return result;
  }

  /// `before`: the relative error of the part of twice this width.
  void resolve(const R& left, const R& width, int halvings, const R& before, const ChebyshevPoints<R>& points,
               std::vector<PanelInterval>& result) const {
    std::vector<R> values;
    for (std::size_t i = 0; i < nodes; ++i) {
      const R place = left + width * (1 + points.place(i)) / 2;
      const R rest = (1 - left - width) + width * (1 - points.place(i)) / 2;
      values.push_back(smooth_({panel_.left + place * panel_.length, place * panel_.length, rest * panel_.length}));
    }
    std::vector<R> series = points.series(values);
    R largest = 0;
    for (const R& coefficient : series) largest = std::max(largest, R(abs(coefficient)));
    const R missed = abs(series[nodes - 1]) + abs(series[nodes - 2]);
    // Next to a logarithm they decrease to a half or less with each halving, and stay above this level.
    const R roundings = largest * epsilon<R>();
    const bool is_rounding = missed <= 1e4 * roundings && missed > before * largest / 2;
    if (missed <= 16 * roundings || is_rounding) {
      result.push_back({left, width, std::move(series)});
    } else if (halvings == most_halvings) {
      result.push_back({left, width, {}});
    } else {
      for (const R& half : {left, R(left + width / 2)}) {
        resolve(half, width / 2, halvings + 1, missed / largest, points, result);
      }
    }
  }

  Panel<R> panel_;
  std::function<R(const Node<R>&)> smooth_;
  Once<std::vector<PanelInterval>> parts_;
};

/// Returns the same density with interpolated smooth factors, which are sampled at first use.
template <Real R>
PanelDensity<R> interpolated(PanelDensity<R> density) {
  const auto factor = std::make_shared<const InterpolatedFactor<R>>(density.panel, std::move(density.smooth));
  density.smooth = [factor](const Node<R>& node) { return (*factor)(node); };
  return density;
}

}  // namespace steadyslide::numeric
