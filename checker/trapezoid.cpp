#include "checker/trapezoid.hpp"

#include <cmath>
#include <numbers>

#include "checker/failure.hpp"

namespace steadyslide::checker {
namespace {

constexpr std::size_t most_nodes = 400000;

}  // namespace

Trapezoid::Trapezoid(Panel panel, slong bits, slong precision) : panel_(std::move(panel)) {
  kappa_ = Ball(2).rounded(precision);
  Ball a = 1, b = 1;  // c + 1 for the powers c at the panel's own ends
  for (const Factor& factor : panel_.factors) {
    const Ball& exponent = factor.exponent;
    const auto add = [&](const std::vector<Ball>& side, Ball& end) {
      for (const Ball& beyond : side) {
        // The factor u^(c + 1) at the panel's own end contributes c + 1, also for c < 0. Any other power contributes
        // its absolute value.
        kappa_ += beyond.is_zero() ? exponent : exponent.size();
        if (beyond.is_zero()) end += exponent;
      }
    };
    add(factor.left, a);
    add(factor.right, b);
  }
  // Choose the strip that needs the fewest nodes; a wider one has a larger bound on its boundary.
  double h = 0;
  double d = 0;
  for (const double width : {1.6, 2.0, 2.4, 2.8}) {
    const double powers = kappa_.approximately() + 3 + static_cast<double>(panel_.degree);
    const double effort = static_cast<double>(bits + 2) * std::numbers::ln2 - powers * std::log(std::cos(width / 2));
    const double step = 2 * std::numbers::pi * width / effort;
    if (step > h) {
      h = step;
      d = width;
    }
  }
  h = std::ldexp(std::round(std::ldexp(h, 20)), -20);
  secant_ = Ball(1) / cos(Ball(d / 2).rounded(precision));
  const Ball suppression = Ball(2) / (exp(Ball(2) * Ball::pi(precision) * Ball(d) / Ball(h)) - Ball(1));

  for (std::size_t more = 0; more < relative_errors_.size(); ++more) {
    relative_errors_.at(more) = suppression * power(secant_, kappa_ + Ball(static_cast<int>(more)));
  }

  if (!a.is_positive() || !b.is_positive() || !panel_.length.is_positive() || !(h > 0)) {
    throw Unproved("a power that is not integrable, or a segment of no length");
  }
  // Returns the node at tau = k h, or the node that represents all nodes beyond it.
  const auto node = [&](slong k, bool all_beyond) {
    const Ball t = Ball(std::fabs(static_cast<double>(k) * h)).rounded(precision);
    const Ball e = all_beyond ? hull(Ball(), exp(-t)) : exp(-t);
    const Ball large = panel_.length / (Ball(1) + e);
    const Ball small = large * e;
    Node result{k < 0 ? small : large, k < 0 ? large : small, {}, {}, {}};
    const Ball& near = k < 0 ? a : b;
    Ball exponent = (a + b) * log(large) - near * t;
    for (const auto& [c, left, right] : panel_.factors) {
      Ball product = 1;
      for (const Ball& beyond : left) product *= beyond.is_zero() ? Ball(1) : result.u + beyond;
      for (const Ball& beyond : right) product *= beyond.is_zero() ? Ball(1) : result.v + beyond;
      exponent += c * log(product);
    }
    result.weight = Ball(h) / panel_.length * exp(exponent);
    if (all_beyond) result.weight = result.weight / (exp(near * Ball(h)) - Ball(1));
    return result;
  };
  Ball total;
  // Goes outwards from the middle until the unknown part of the rest, also with a pole beside it, is negligible.
  const auto march = [&](slong first, slong step, const Ball& reach) {
    const Ball wanted =
        (Ball(1) + panel_.length / reach) * Ball(std::ldexp(1.0, static_cast<int>(std::min<slong>(bits, 1000))));
    for (slong k = first;; k += step) {
      nodes_.push_back(node(k, false));
      total += nodes_.back().weight;
      if (nodes_.size() > most_nodes) throw Unproved("an integral that needs too many nodes");
      if ((k & 7) != 0) continue;
      const Node rest = node(k, true);
      const Ball unknown = rest.weight.radius() + rest.weight * (step < 0 ? rest.u : rest.v) / reach;
      if (!(total - unknown.size() * wanted).is_positive()) continue;
      nodes_.push_back(rest);
      return;
    }
  };
  march(0, 1, panel_.right_reach);
  nodes_to_right_ = nodes_.size();
  march(-1, -1, panel_.left_reach);
  Bound behind;
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    if (k + 1 == nodes_to_right_) behind = Bound();
    nodes_[k].above = nodes_[k].weight.bound();
    mag_add(behind.get(), behind.get(), nodes_[k].above.get());
    nodes_[k].behind = behind;
  }
  if (!(Ball(0.5) - relative_error(2)).is_positive()) throw Unproved("a quadrature without accuracy");
}

}  // namespace steadyslide::checker
