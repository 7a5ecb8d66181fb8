#pragma once
// The nodes of the trapezoidal rule in tau, x = tanh(tau/2), and the end powers at them: from_left = length/(1+e^-tau),
// from_right = from_left e^-tau, and log(from_left/from_right) = tau. For trapezoidal.cpp.

#include <vector>

#include "numeric/cauchy/density.hpp"

namespace steadyslide::numeric::trapezoidal {

/// -log(epsilon): the accuracy to be reached, as an exponent.
template <Real R>
R accuracy() {
  using std::log;
  return -log(epsilon<R>());
}

/// Principal values may be taken as near as e^-margin of a panel to its ends.
template <Real R>
R margin() {
  return 20;
}

/// What every panel's nodes at +-tau, tau >= 0, are made of.
template <Real R>
struct UnitNode {
  R exponential;  ///< e^-tau
  R sum;          ///< 1 + e^-tau
  R logarithm;    ///< log(1 + e^-tau)

  static UnitNode at(const R& tau) {
    using std::exp, std::log;
    const R e = exp(R(-tau));
    return {e, R(1 + e), log(R(1 + e))};
  }
};

/// A step of few bits makes every k h exact: nodes that jitter by a rounding would be the largest error of all.
template <Real R>
R step_length() {
  using std::floor;
  // The integrand is analytic for |Im tau| < pi, with branch points on the border: a little more than the accuracy.
  return floor(R(1024 * 2 * pi<R>() * pi<R>() / (accuracy<R>() + 12))) / 1024;
}

/// At 0, h, 2h, ...: the same for all grids, and logarithms are what costs most in them.
template <Real R>
const std::vector<UnitNode<R>>& unit_nodes() {
  static const std::vector<UnitNode<R>> nodes = [] {
    std::vector<UnitNode<R>> result;
    const R last = accuracy<R>() + 2 * margin<R>();
    for (R tau = 0; tau < last; tau += step_length<R>()) result.push_back(UnitNode<R>::at(tau));
    return result;
  }();
  return nodes;
}

template <Real R>
Node<R> node_at(const Panel<R>& panel, const UnitNode<R>& unit, bool right_half) {
  // Both distances from the smaller exponential: neither overflows, neither cancels.
  const R far = panel.length / unit.sum;
  const R near = far * unit.exponential;
  return right_half ? Node<R>{panel.right - near, far, near} : Node<R>{panel.left + near, near, far};
}

template <Real R>
Node<R> node_at(const Panel<R>& panel, const R& tau) {
  using std::abs;
  return node_at(panel, UnitNode<R>::at(abs(tau)), tau > 0);
}

/// from_left^(1+lambda) from_right^(1+mu), lambda and mu the density's end powers. In higher precision it is one
/// exponential. Its argument costs digits where it is large, but then it is negative: the factor is as small as they
/// are few, and the sums do not feel it.
template <Real R>
class EndPowers {
 public:
  explicit EndPowers(const PanelDensity<R>& density) : left_(density.left.plus_one), right_(density.right.plus_one) {
    using std::log;
    if constexpr (!std::same_as<R, double>) log_length_ = log(density.panel.length);
  }

  R at(const Node<R>& node, const UnitNode<R>& unit, const R& tau) const {
    using std::exp, std::pow;
    if (left_ == 1 && right_ == 1) return node.from_left * node.from_right;
    if constexpr (std::same_as<R, double>) {
      return pow(node.from_left, left_) * pow(node.from_right, right_);
    } else {
      // log(from_left/from_right) is tau.
      return exp(R((left_ + right_) * (log_length_ - unit.logarithm) + (tau > 0 ? R(-right_ * tau) : R(left_ * tau))));
    }
  }

 private:
  R left_;
  R right_;
  R log_length_ = 0;
};

}  // namespace steadyslide::numeric::trapezoidal
