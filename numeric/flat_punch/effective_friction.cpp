#include "numeric/flat_punch/effective_friction.hpp"

#include <algorithm>

namespace steadyslide::numeric {

template <Real R>
EffectiveFriction<R>::EffectiveFriction(FrictionLayout<R> layout) : layout_(std::move(layout)) {
  using std::ceil, std::exp, std::log, std::log1p, std::sqrt;
  const R digits = -log(epsilon<R>());
  // A margin for what stands before e^(-2 pi^2/h), with the poles of w on the edge of the strip.
  step_ = 2 * pi<R>() * pi<R>() / (digits + 6);
  const auto& strips = layout_.strips();
  const R& length = layout_.length();
  // Left of the first node A and B differ from their limits by less than epsilon; right of the last one the first two
  // orders in 1/d are exact.
  const R first = log(epsilon<R>() * std::min(strips.front().length, strips.back().length));
  const R last = log(16 * length / sqrt(epsilon<R>()));
  const int count = static_cast<int>(ceil((last - first) / step_));
  nodes_.reserve(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i <= count; ++i) {
    const R d = exp(first + i * step_);
    Node node{d, step_ / pi<R>() * sqrt(d / (d + length)), R(0), R(0), R(1), R(1)};
    for (const FrictionStrip<R>& strip : strips) {
      if (strip.alpha == 0) continue;
      node.a += strip.alpha * log1p(strip.length / (d + strip.from_left));
      node.b += strip.alpha * log1p(strip.length / (d + strip.from_right));
    }
    node.exp_a = exp(node.a);
    node.exp_minus_b = exp(-node.b);
    nodes_.push_back(std::move(node));
  }
}

template <Real R>
R EffectiveFriction<R>::left_tail(const R& first, const R& power) const {
  using std::expm1;
  return first / expm1(step_ * power);
}

template <Real R>
R EffectiveFriction<R>::relative_error() const {
  using std::abs;
  return (16 + abs(nodes_.front().a) + abs(nodes_.front().b)) * epsilon<R>();
}

template <Real R>
Estimate<R> EffectiveFriction<R>::value() const {
  using std::expm1;
  const auto term = [](const Node& node) { return R(node.weight * (expm1(node.a) - expm1(-node.b))); };
  R sum = term(nodes_.back()) / expm1(step_);  // beyond the last node terms fall like 1/d
  for (const Node& node : nodes_) sum += term(node);
  const Node& first = nodes_.front();
  sum += left_tail(first.weight * first.exp_a, layout_.strips().front().below_half);
  sum -= left_tail(first.weight * first.exp_minus_b, layout_.strips().back().above_half);
  return Estimate<R>{sum, R(0)}.widened(relative_error());
}

template <Real R>
Estimate<R> EffectiveFriction<R>::direction_difference() const {
  using std::abs, std::exp, std::sinh;
  R sum = 0;
  R size = 0;
  // Terms fall like 1/d^3: nothing is left beyond the last node.
  for (const Node& node : nodes_) {
    const R mean = 4 * node.weight * sinh((node.a + node.b) / 2);
    sum += mean * sinh((node.a - node.b) / 2);
    size += abs(mean) * (abs(node.a) + abs(node.b));  // A - B cancels
  }
  const auto add = [&](const R& term, const R& power) {
    const R tail = left_tail(nodes_.front().weight * term, power);
    sum += tail;
    size += abs(tail);
  };
  const Node& first = nodes_.front();
  const FrictionStrip<R>& left = layout_.strips().front();
  const FrictionStrip<R>& right = layout_.strips().back();
  add(first.exp_a, left.below_half);
  add(exp(-first.a), left.above_half);
  add(-exp(first.b), right.below_half);
  add(-first.exp_minus_b, right.above_half);
  return {sum, relative_error() * size};
}

template <Real R>
Estimate<R> EffectiveFriction<R>::derivative(const R& from_left, const R& from_right) const {
  using std::expm1;
  const auto behind = [&](const Node& node) { return R(node.weight * node.exp_a / (node.d + from_left)); };
  const auto ahead = [&](const Node& node) { return R(node.weight * node.exp_minus_b / (node.d + from_right)); };
  const Node& first = nodes_.front();
  const Node& last = nodes_.back();
  R sum = (behind(last) + ahead(last)) / expm1(step_);
  for (const Node& node : nodes_) sum += behind(node) + ahead(node);
  sum += left_tail(behind(first), layout_.strips().front().below_half);
  sum += left_tail(ahead(first), layout_.strips().back().above_half);
  // dx/(x+y) has no unit, and y runs over 2 where x - 1 runs over the layout's length.
  return Estimate<R>{sum * layout_.length() / 2, R(0)}.widened(relative_error());
}

template class EffectiveFriction<double>;
template class EffectiveFriction<Real50>;
template class EffectiveFriction<Real100>;

}  // namespace steadyslide::numeric
