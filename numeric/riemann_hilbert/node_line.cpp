#include "numeric/riemann_hilbert/node_line.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/hierarchical/line_sum.hpp"

namespace steadyslide::numeric {
namespace {

constexpr std::size_t no_panel = static_cast<std::size_t>(-1);

/// The distances of a place from the ends of its part of a segment.
std::pair<double, double> within(const SegmentPart<double>& part, const Node<double>& node) {
  // From the end of the segment that is nearer to the part: there the difference loses nothing.
  const bool by_left = part.from_left <= part.from_right;
  const double left = by_left ? node.from_left - part.from_left : part.length - (node.from_right - part.from_right);
  const double right = by_left && part.from_right > 0 ? part.length - left : node.from_right - part.from_right;
  return {std::clamp(left, 0.0, part.length), std::clamp(right, 0.0, part.length)};
}

}  // namespace

NodeLine::NodeLine(const SignedFundamentalSolution<double>& y, const Panels& panels,
                   std::span<const SurfacePoint<double>> nodes, std::span<const double> weights)
    : y_(&y), segments_(panels.segments), weights_(static_cast<std::size_t>(y.problem().highest_degree()) + 3) {
  const ContactSet<double>& set = y.set();
  std::size_t panel = 0;
  for (std::size_t segment = segments_.first; segment < segments_.end; ++segment) {
    first_leaf_.push_back(leaves_.size());
    if (!set.in_contact(segment)) {
      leaves_.push_back({whole_segment(set, segment), no_panel});
      lengths_.push_back(set.length(segment));
    }
    for (; panel < panels.parts.size() && panels.parts[panel].segment == segment; ++panel) {
      const std::size_t end = panel + 1 < panels.parts.size() ? panels.first_node[panel + 1] : nodes.size();
      add_panel(panels.first_panel + panel, panels.parts[panel], panels.first_node[panel], end, nodes, weights);
    }
  }
  first_leaf_.push_back(leaves_.size());
}

void NodeLine::add_panel(std::size_t panel, const SegmentPart<double>& part, std::size_t first, std::size_t end,
                         std::span<const SurfacePoint<double>> nodes, std::span<const double> weights) {
  // Rules count their nodes from the end where the power sits. Far from one end only the distance from the other tells.
  const Node<double>& a = nodes[first].node;
  const Node<double>& b = nodes[end - 1].node;
  const bool mirrored = part.from_left <= part.from_right ? a.from_left > b.from_left : a.from_right < b.from_right;
  for (std::size_t n = first; n < end; ++n) {
    const std::size_t i = mirrored ? first + end - 1 - n : n;
    const Node<double>& node = nodes[i].node;
    const auto [from_left, from_right] = within(part, node);
    sources_.push_back({leaves_.size(), from_left, from_right});
    const double slope = y_->problem().slope(y_->slope_at(part.segment), node.x);
    largest_slope_ = std::max(largest_slope_, std::abs(slope));
    largest_place_ = std::max(largest_place_, std::abs(node.x));
    weights_[0].push_back(weights[i] * slope);
    double term = weights[i];
    for (std::size_t m = 1; m + 1 < weights_.size(); ++m) {
      weights_[m].push_back(term);
      term *= node.x;
    }
    weights_.back().push_back(std::abs(weights[i]));
  }
  leaves_.push_back({part, panel});
  lengths_.push_back(part.length);
}

NodeLine::Place NodeLine::place(const SurfacePoint<double>& at) const {
  const std::size_t leaf = leaf_at(at);
  const auto [from_left, from_right] = within(leaves_[leaf].part, at.node);
  return {leaf, from_left, from_right};
}

std::size_t NodeLine::leaf_at(const SurfacePoint<double>& at) const {
  const auto segment = static_cast<std::size_t>(at.segment);
  const auto first = leaves_.begin() + static_cast<std::ptrdiff_t>(first_leaf(segment));
  const auto end = leaves_.begin() + static_cast<std::ptrdiff_t>(first_leaf(segment + 1));
  const auto next =
      at.node.from_left < at.node.from_right
          ? std::partition_point(first, end, [&](const Leaf& l) { return l.part.from_left <= at.node.from_left; })
          : std::partition_point(first, end, [&](const Leaf& l) { return l.part.from_right > at.node.from_right; });
  if (at.node.from_left < at.node.from_right)
    return static_cast<std::size_t>(std::max(next, first + 1) - leaves_.begin()) - 1;
  return static_cast<std::size_t>(std::min(next, end - 1) - leaves_.begin());
}

Estimate<double> NodeLine::combined(const std::vector<double>& slope, const std::vector<double>& sums) const {
  Estimate<double> result{sums[0], 0};
  double largest = largest_slope_;
  double place = 1;
  for (std::size_t m = 0; m < slope.size(); ++m) {
    result.value -= slope[m] * sums[m + 1];
    largest += std::abs(slope[m]) * place;
    place *= largest_place_;
  }
  result.error = hierarchical::cauchy_rounding / 4 * sums.back() * largest;
  return result;
}

}  // namespace steadyslide::numeric
