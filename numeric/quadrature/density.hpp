#pragma once
// A traction given panel by panel. On each panel it is a product of powers of the distances from both ends and of a
// function that is analytic up to the ends. All quadrature routes integrate this form.

#include <functional>
#include <vector>

#include "numeric/number/node.hpp"
#include "numeric/number/power.hpp"

namespace steadyslide::numeric {

/// t(x) = from_left^{left.value} from_right^{right.value} smooth(node), both powers > -1.
/// `smooth` may have branch points on the real axis outside the closed panel, and no other singularities.
template <Real R>
struct PanelDensity {
  Panel<R> panel;
  Power<R> left;
  Power<R> right;
  std::function<R(const Node<R>&)> smooth;
  R gap = 0;                 ///< distance from the previous panel; no contact in between
  bool is_constant = false;  ///< `smooth` is constant

  R operator()(const Node<R>& node) const {
    R value = smooth(node);
    multiply(value, left, node.from_left);
    multiply(value, right, node.from_right);
    return value;
  }
  const Power<R>& power(Side end) const { return end == Side::left ? left : right; }
  /// Returns t without the power of that end.
  R without_power(Side end, const Node<R>& node) const {
    R value = smooth(node);
    multiply(value, power(opposite(end)), end == Side::left ? node.from_right : node.from_left);
    return value;
  }

 private:
  static void multiply(R& value, const Power<R>& power, const R& distance) {
    if (power.value != 0) value *= pow(distance, power.value);
  }
};

/// Panels from left to right that do not overlap. There is no contact in the gaps between them.
template <Real R>
using PiecewiseDensity = std::vector<PanelDensity<R>>;

/// A point inside panel `panel` of a density.
template <Real R>
struct PanelPoint {
  std::size_t panel;
  Node<R> node;
};

/// Returns the distance between panels j and k, j != k: a sum of positive numbers.
template <Real R>
R distance_between(const PiecewiseDensity<R>& density, std::size_t j, std::size_t k) {
  const auto [first, last] = std::minmax(j, k);
  R distance = 0;
  for (std::size_t i = first; i < last; ++i) {
    if (i > first) distance += density[i].panel.length;
    distance += density[i + 1].gap;
  }
  return distance;
}

}  // namespace steadyslide::numeric
