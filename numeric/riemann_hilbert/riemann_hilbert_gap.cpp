// The Riemann-Hilbert form over gaps: heights by exact integration of Y B.

#include <cmath>
#include <stdexcept>

#include "numeric/number/polynomial_roots.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_form.hpp"

namespace steadyslide::numeric {

template <Real R>
std::size_t RiemannHilbertForm<R>::slope_for_gap(std::size_t segment, bool left_half) const {
  // Next to an end at a break, B_k is smooth for the k of the contact.
  const bool left = set_.point(segment).is_end();
  const bool right = set_.point(segment + 1).is_end();
  if (left && (left_half || !right)) return slope_at(segment - 1);
  if (right) return slope_at(segment + 1);
  return slope_at(segment);
}

template <Real R>
bool RiemannHilbertForm<R>::changes_slope(std::size_t segment) const {
  return slope_for_gap(segment, true) != slope_for_gap(segment, false);
}

template <Real R>
void RiemannHilbertForm<R>::add_gap_nodes(std::size_t segment, const Stretch& stretch,
                                          std::vector<GapNode>& nodes) const {
  const R middle = set_.length(segment) / 2;
  const bool right_half = stretch.from_left >= middle;
  if (!changes_slope(segment) || right_half || stretch.from_right >= middle) {
    add_gap_nodes(segment, stretch, slope_for_gap(segment, !right_half), nodes);
    return;
  }
  add_gap_nodes(segment, {stretch.from_left, R(middle - stretch.from_left), middle}, slope_for_gap(segment, true),
                nodes);
  add_gap_nodes(segment, {middle, R(middle - stretch.from_right), stretch.from_right}, slope_for_gap(segment, false),
                nodes);
}

template <Real R>
void RiemannHilbertForm<R>::add_gap_nodes(std::size_t segment, const Stretch& stretch, std::size_t slope,
                                          std::vector<GapNode>& nodes) const {
  const auto power_of = [this](std::size_t j) {
    const Power<R>& p = weight_.powers()[j];
    return set_.point(j).vanishes ? Power<R>{R(p.value - 1), p.value} : p;
  };
  for (const Part& part :
       parts(segment, stretch, surroundings(segment, true), nodes_per_panel() + std::max(-degree_, 0), power_of)) {
    for (std::size_t i = 0; i < part.rule->size(); ++i) {
      const SurfacePoint<R> at = part.node(set_, i);
      nodes.push_back({at, slope, part.node_weight(i), R(sign(at.segment) * modulus(at))});
    }
  }
}

template <Real R>
R RiemannHilbertForm<R>::slope_difference(std::size_t segment, const R& from, const R& length) const {
  // The nodes change their k in the middle of a segment that has contact at both ends.
  const std::size_t own = slope_at(segment);
  const R middle = set_.length(segment) / 2;
  const R end = from + length;
  R sum = 0;
  const auto add = [&](std::size_t k, const R& a, const R& b) {
    if (k == own || a >= b) return;
    const R left = surface_point(set_, segment, a, R(set_.length(segment) - a)).node.x;
    const R right = surface_point(set_, segment, b, R(set_.length(segment) - b)).node.x;
    sum += problem_->rise(own, left, right) - problem_->rise(k, left, right);
  };
  add(slope_for_gap(segment, true), from, std::min(end, middle));
  add(slope_for_gap(segment, false), std::max(from, middle), end);
  return sum;
}

template <Real R>
std::vector<typename RiemannHilbertForm<R>::GapNode> RiemannHilbertForm<R>::gap_rule(std::size_t j) const {
  std::vector<GapNode> nodes;
  for (std::size_t k = j; k < set_.segments() && !set_.in_contact(k); ++k) {
    add_gap_nodes(k, whole(k), nodes);
  }
  return nodes;
}

template <Real R>
R RiemannHilbertForm<R>::rate(const GapNode& node) const {
  return node.y * bracket(node.slope, node.at).value;
}

template <Real R>
R RiemannHilbertForm<R>::closure(std::size_t j, const std::vector<GapNode>& rule) const {
  R sum = 0;
  std::size_t k = j;
  for (; k < set_.segments() && !set_.in_contact(k); ++k) {
    if (set_.point(k).anchor) sum += problem_->anchors()[*set_.point(k).anchor].step;
    sum += slope_difference(k, R(0), set_.length(k));
  }
  if (set_.point(k).anchor) sum += problem_->anchors()[*set_.point(k).anchor].step;
  for (const GapNode& node : rule) sum += node.weight * rate(node);
  return sum;
}

template <Real R>
Estimate<R> RiemannHilbertForm<R>::opening(std::size_t j, const SurfacePoint<R>& at) const {
  using std::abs;
  if (at.segment < 0 || at.segment >= static_cast<std::ptrdiff_t>(set_.segments())) {
    throw std::domain_error("a gap off the support: there is no indenter");
  }
  const bool rightwards = static_cast<std::ptrdiff_t>(j) <= at.segment;
  std::vector<GapNode> nodes;
  R sum = 0;
  R size = 0;
  const auto add_step = [&](std::size_t point) {
    if (!set_.point(point).anchor) return;
    const R& step = problem_->anchors()[*set_.point(point).anchor].step;
    sum += step;
    size += abs(step);
  };
  const auto segment = static_cast<std::size_t>(at.segment);
  if (rightwards) {
    for (std::size_t k = j; k < segment; ++k) {
      add_step(k);
      add_gap_nodes(k, whole(k), nodes);
      sum += slope_difference(k, R(0), set_.length(k));
    }
    add_step(segment);
    add_gap_nodes(segment, {R(0), at.node.from_left, at.node.from_right}, nodes);
    sum += slope_difference(segment, R(0), at.node.from_left);
  } else {
    for (std::size_t k = j; k-- > segment + 1;) {
      add_step(k + 1);
      add_gap_nodes(k, whole(k), nodes);
      sum += slope_difference(k, R(0), set_.length(k));
    }
    add_step(segment + 1);
    add_gap_nodes(segment, {at.node.from_left, at.node.from_right, R(0)}, nodes);
    sum += slope_difference(segment, at.node.from_left, at.node.from_right);
  }
  for (const GapNode& node : nodes) {
    const Estimate<R> b = bracket(node.slope, node.at);
    sum += node.weight * node.y * b.value;
    size += abs(node.weight * node.y) * (abs(b.value) + b.error / epsilon<R>());
  }
  return {rightwards ? sum : R(-sum), 4 * epsilon<R>() * size};
}

template <Real R>
std::vector<SurfacePoint<R>> RiemannHilbertForm<R>::extremes(std::size_t segment) const {
  std::vector<double> g;
  for (const R& c : problem_->slopes()[slope_at(segment)]) g.push_back(static_cast<double>(c));
  if (g.empty()) return {};
  g[0] += static_cast<double>(tilt_);
  std::vector<SurfacePoint<R>> result;
  const R& left = set_.x(segment);
  const R& right = set_.x(segment + 1);
  for (const double x : sign_changes(g, static_cast<double>(left), static_cast<double>(right))) {
    if (!(R(x) > left && R(x) < right)) continue;
    result.push_back({static_cast<std::ptrdiff_t>(segment), {R(x), R(x - left), R(right - x)}});
  }
  return result;
}

template <Real R>
R RiemannHilbertForm<R>::profile_rise(std::size_t j, const SurfacePoint<R>& at) const {
  const auto segment = static_cast<std::size_t>(at.segment);
  const bool rightwards = j <= segment;
  const auto step = [&](std::size_t point) {
    return set_.point(point).anchor ? problem_->anchors()[*set_.point(point).anchor].step : R(0);
  };
  R sum = tilt_ * distance(at, j);
  if (rightwards) {
    for (std::size_t k = j; k < segment; ++k) {
      sum += step(k) + problem_->rise(slope_at(k), set_.x(k), set_.x(k + 1));
    }
    return sum + step(segment) + problem_->rise(slope_at(segment), set_.x(segment), at.node.x);
  }
  for (std::size_t k = j; k-- > segment + 1;) {
    sum -= step(k + 1) + problem_->rise(slope_at(k), set_.x(k), set_.x(k + 1));
  }
  return sum - step(segment + 1) - problem_->rise(slope_at(segment), at.node.x, set_.x(segment + 1));
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                                    \
  template std::size_t RiemannHilbertForm<R>::slope_for_gap(std::size_t segment, bool left_half) const;               \
  template bool RiemannHilbertForm<R>::changes_slope(std::size_t segment) const;                                      \
  template void RiemannHilbertForm<R>::add_gap_nodes(std::size_t segment, const Stretch& stretch,                     \
                                                     std::vector<GapNode>& nodes) const;                              \
  template void RiemannHilbertForm<R>::add_gap_nodes(std::size_t segment, const Stretch& stretch, std::size_t slope,  \
                                                     std::vector<GapNode>& nodes) const;                              \
  template R RiemannHilbertForm<R>::slope_difference(std::size_t segment, const R& from, const R& length) const;      \
  template std::vector<typename RiemannHilbertForm<R>::GapNode> RiemannHilbertForm<R>::gap_rule(std::size_t j) const; \
  template R RiemannHilbertForm<R>::rate(const GapNode& node) const;                                                  \
  template R RiemannHilbertForm<R>::closure(std::size_t j, const std::vector<GapNode>& rule) const;                   \
  template Estimate<R> RiemannHilbertForm<R>::opening(std::size_t j, const SurfacePoint<R>& at) const;                \
  template std::vector<SurfacePoint<R>> RiemannHilbertForm<R>::extremes(std::size_t segment) const;                   \
  template R RiemannHilbertForm<R>::profile_rise(std::size_t j, const SurfacePoint<R>& at) const;
STEADYSLIDE_INSTANTIATE(double)
STEADYSLIDE_INSTANTIATE(Real50)
STEADYSLIDE_INSTANTIATE(Real100)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
