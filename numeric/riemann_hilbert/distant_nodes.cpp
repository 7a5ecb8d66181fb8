#include "numeric/riemann_hilbert/distant_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::numeric {

std::pair<double, double> DistantNodes::within(const SegmentPart<double>& part, const Node<double>& node) {
  // From the end of the segment that is nearer to the part: there the difference loses nothing.
  const bool by_left = part.from_left <= part.from_right;
  const double left = by_left ? node.from_left - part.from_left : part.length - (node.from_right - part.from_right);
  const double right = by_left && part.from_right > 0 ? part.length - left : node.from_right - part.from_right;
  return {std::clamp(left, 0.0, part.length), std::clamp(right, 0.0, part.length)};
}

hierarchical::LineSum DistantNodes::sum_over(const SignedFundamentalSolution<double>& y, const Panels& panels,
                                             const std::vector<SurfacePoint<double>>& nodes,
                                             const std::vector<double>& weights) {
  using Kernel = hierarchical::LineSum::Kernel;
  const ContactSet<double>& set = y.set();
  const auto powers = static_cast<std::size_t>(y.problem().highest_degree()) + 1;
  std::vector<double> lengths;
  std::vector<hierarchical::Source> sources;
  std::vector<Kernel> kernels(powers + 1, Kernel::cauchy);
  kernels.push_back(Kernel::distance);
  std::vector<std::vector<double>> sums(kernels.size());
  const auto add_panel = [&](std::size_t panel) {
    const SegmentPart<double>& part = panels.parts[panel];
    const std::size_t end = panel + 1 < panels.parts.size() ? panels.first_node[panel + 1] : nodes.size();
    // Rules count their nodes from the end where the power sits.
    const bool mirrored = nodes[panels.first_node[panel]].node.from_left > nodes[end - 1].node.from_left;
    for (std::size_t n = panels.first_node[panel]; n < end; ++n) {
      const std::size_t i = mirrored ? panels.first_node[panel] + end - 1 - n : n;
      const Node<double>& node = nodes[i].node;
      const auto [from_left, from_right] = within(part, node);
      sources.push_back({lengths.size(), from_left, from_right});
      const double slope = y.problem().slope(y.slope_at(part.segment), node.x);
      largest_slope_ = std::max(largest_slope_, std::abs(slope));
      largest_place_ = std::max(largest_place_, std::abs(node.x));
      sums[0].push_back(weights[i] * slope);
      double term = weights[i];
      for (std::size_t m = 0; m < powers; ++m) {
        sums[m + 1].push_back(term);
        term *= node.x;
      }
      sums.back().push_back(std::abs(weights[i]));
    }
    leaves_.push_back({part.segment, part.from_left, part.length, part.from_right, panel});
    lengths.push_back(part.length);
  };
  std::size_t panel = 0;
  for (std::size_t segment = 0; segment < set.segments(); ++segment) {
    first_leaf_.push_back(leaves_.size());
    if (!set.in_contact(segment)) {
      leaves_.push_back({segment, 0, set.length(segment), 0, none});
      lengths.push_back(set.length(segment));
    }
    for (; panel < panels.parts.size() && panels.parts[panel].segment == segment; ++panel) add_panel(panel);
  }
  first_leaf_.push_back(leaves_.size());
  return {kernels, lengths, sources, sums};
}

DistantNodes::DistantNodes(const SignedFundamentalSolution<double>& y, const Panels& panels,
                           const std::vector<SurfacePoint<double>>& nodes, const std::vector<double>& weights)
    : sum_(sum_over(y, panels, nodes, weights)) {}

std::size_t DistantNodes::leaf_at(const SurfacePoint<double>& at) const {
  const auto segment = static_cast<std::size_t>(at.segment);
  const auto first = leaves_.begin() + static_cast<std::ptrdiff_t>(first_leaf_[segment]);
  const auto end = leaves_.begin() + static_cast<std::ptrdiff_t>(first_leaf_[segment + 1]);
  const auto next =
      at.node.from_left < at.node.from_right
          ? std::partition_point(first, end, [&](const Leaf& l) { return l.from_left <= at.node.from_left; })
          : std::partition_point(first, end, [&](const Leaf& l) { return l.from_right > at.node.from_right; });
  if (at.node.from_left < at.node.from_right)
    return static_cast<std::size_t>(std::max(next, first + 1) - leaves_.begin()) - 1;
  return static_cast<std::size_t>(std::min(next, end - 1) - leaves_.begin());
}

Estimate<double> DistantNodes::combined(const std::vector<double>& slope, const std::vector<double>& sums) const {
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
