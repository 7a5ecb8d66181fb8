#pragma once
// int eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x) over the panels of a contact that are far from x, for many x and k, by
// cells (numeric/hierarchical/), in double. The caller adds the panels near x.

#include <algorithm>
#include <cmath>
#include <span>

#include "numeric/hierarchical/line_sum.hpp"
#include "numeric/hierarchical/pivot_sum.hpp"
#include "numeric/number/estimate.hpp"
#include "numeric/riemann_hilbert/jacobi_panels.hpp"

namespace steadyslide::numeric {

/// The quadrature nodes x_i of a contact as sources on a line, in double. The panels of the line are the panels of the
/// contact and the segments without contact. With the rule's weights w_i (of any sign) and g_k = sum_m a_m x^m, for a
/// kernel K,
///
///   sum_i w_i (g - g_k) K(x_i) = F[w g] - sum_m a_m F[w x^m],   F[v] = sum_i v_i K(x_i),
///
/// is a difference of sums of the size of w g, while w (g - g_k) may be small. So the error is that of sum_i |w_i
/// K(x_i)| (max |g| + sum_m |a_m| max |x|^m).
class NodeLine {
 public:
  /// The segments first..end-1.
  struct Segments {
    std::size_t first;
    std::size_t end;
  };
  /// A panel of the contact, or a segment without contact.
  struct Leaf {
    SegmentPart<double> part;
    std::size_t panel;
  };

  /// `y` must outlive this object. `panels_of(segment, add)` calls add(number, part, nodes, weights) for each panel of
  /// a segment, from left to right.
  template <class PanelsOf>
  NodeLine(const SignedFundamentalSolution<double>& y, const Segments& segments, const PanelsOf& panels_of)
      : y_(&y), segments_(segments), weights_(static_cast<std::size_t>(y.problem().highest_degree()) + 3) {
    for (std::size_t segment = segments.first; segment < segments.end; ++segment) {
      first_leaf_.push_back(leaves_.size());
      if (y.set().in_contact(segment)) {
        panels_of(segment, [this](std::size_t panel, const SegmentPart<double>& part,
                                  std::span<const SurfacePoint<double>> nodes, std::span<const double> weights) {
          add_panel(part, nodes, weights);
          add_leaf({part, panel});
        });
      } else {
        add_leaf({whole_segment(y.set(), segment), static_cast<std::size_t>(-1)});
      }
    }
    first_leaf_.push_back(leaves_.size());
  }

  const std::vector<double>& lengths() const { return lengths_; }
  const std::vector<hierarchical::Source>& sources() const { return sources_; }
  /// The weights of the sums: w g, then w x^m for m = 0, 1, ..., and finally |w|.
  const std::vector<std::vector<double>>& weights() const { return weights_; }

  const Leaf& leaf(std::size_t k) const { return leaves_[k]; }
  /// Returns the first leaf of a segment; for the end of the segments, the one after the last leaf.
  std::size_t first_leaf(std::size_t segment) const { return first_leaf_[segment - segments_.first]; }
  bool is_left_of(const SurfacePoint<double>& at) const {
    return at.segment >= static_cast<std::ptrdiff_t>(segments_.end);
  }
  bool is_right_of(const SurfacePoint<double>& at) const {
    return at.segment < static_cast<std::ptrdiff_t>(segments_.first);
  }
  /// Returns the distance from the line's nearer end to a place beyond it.
  double distance_beyond(const SurfacePoint<double>& at) const {
    return is_left_of(at) ? y_->distance(at, segments_.end) : -y_->distance(at, segments_.first);
  }
  /// Returns the place, in a leaf or outside the line.
  hierarchical::PivotSum::PanelPoint place(const SurfacePoint<double>& at) const {
    if (is_right_of(at)) return {-1, 0, 0};
    if (is_left_of(at)) return {static_cast<std::ptrdiff_t>(leaves_.size()), 0, 0};
    const auto segment = static_cast<std::size_t>(at.segment);
    const auto first = leaves_.begin() + static_cast<std::ptrdiff_t>(first_leaf(segment));
    const auto end = leaves_.begin() + static_cast<std::ptrdiff_t>(first_leaf(segment + 1));
    const Node<double>& node = at.node;
    const bool by_left = node.from_left < node.from_right;
    const auto next = std::partition_point(first, end, [&](const Leaf& leaf) {
      return by_left ? leaf.part.from_left <= node.from_left : leaf.part.from_right > node.from_right;
    });
    const auto leaf = by_left ? std::max(next, first + 1) - 1 : std::min(next, end - 1);
    const auto [from_left, from_right] = within(leaf->part, node);
    return {leaf - leaves_.begin(), from_left, from_right};
  }
  /// Returns sum_i w_i (g - g_k) K(x_i) from the sums, with the error in units of 4 epsilon.
  Estimate<double> combined(const std::vector<double>& slope, const std::vector<double>& sums) const {
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

 private:
  /// Returns the distances of a place from the ends of its part of a segment.
  static std::pair<double, double> within(const SegmentPart<double>& part, const Node<double>& node) {
    // Measure from the end of the segment that is nearer to the part, because there the difference keeps its digits.
    const bool by_left = part.from_left <= part.from_right;
    const double left = by_left ? node.from_left - part.from_left : part.length - (node.from_right - part.from_right);
    const double right = by_left && part.from_right > 0 ? part.length - left : node.from_right - part.from_right;
    return {std::clamp(left, 0.0, part.length), std::clamp(right, 0.0, part.length)};
  }

  void add_leaf(const Leaf& leaf) {
    leaves_.push_back(leaf);
    lengths_.push_back(leaf.part.length);
  }

  void add_panel(const SegmentPart<double>& part, std::span<const SurfacePoint<double>> nodes,
                 std::span<const double> weights) {
    // Rules number their nodes from the end with the power. Far from one end, only the distance from the other end can
    // order them.
    const Node<double>& a = nodes.front().node;
    const Node<double>& b = nodes.back().node;
    const bool mirrored = part.from_left <= part.from_right ? a.from_left > b.from_left : a.from_right < b.from_right;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const std::size_t i = mirrored ? nodes.size() - 1 - n : n;
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
  }

  const SignedFundamentalSolution<double>* y_;
  Segments segments_;
  std::vector<double> lengths_;
  std::vector<hierarchical::Source> sources_;
  std::vector<std::vector<double>> weights_;
  std::vector<Leaf> leaves_;
  std::vector<std::size_t> first_leaf_;  ///< for each segment, and one more entry
  double largest_slope_ = 0;
  double largest_place_ = 0;
};

/// Sums with one weight for all places.
class DistantNodes {
 public:
  explicit DistantNodes(NodeLine line)
      : line_(std::move(line)), sum_(kernels_of(line_), line_.lengths(), line_.sources(), line_.weights()) {}

  /// Returns the sum over far panels, with g_k given by its coefficients, and calls visit(panel, distance of its nearer
  /// end) for the others. Panels of the segment that contains x are left out. The error is in units of 4 epsilon.
  template <class Visit>
  Estimate<double> around(const std::vector<double>& slope, const SurfacePoint<double>& at, const Visit& visit) const {
    std::vector<double> sums(sum_.sums(), 0);
    const bool is_left = line_.is_right_of(at);
    if (is_left || line_.is_left_of(at)) {
      const auto takes = [&](std::size_t cell, Side side, double distance) {
        if (!sum_.tree().is_far(cell, distance)) return false;
        for (std::size_t s = 0; s < sums.size(); ++s) sums[s] += sum_.of_cell(s, cell, side, distance);
        return true;
      };
      const auto near = [&](std::size_t leaf, double gap, Side) { visit(line_.leaf(leaf).panel, gap); };
      sum_.tree().beyond(is_left ? Side::left : Side::right, line_.distance_beyond(at), takes, near);
      return line_.combined(slope, sums);
    }
    const auto [panel, from_left, from_right] = line_.place(at);
    const auto k = static_cast<std::size_t>(panel);
    for (const auto& [leaf, between] : sum_.near_to(k)) {
      if (line_.leaf(leaf).part.segment != line_.leaf(k).part.segment)
        visit(line_.leaf(leaf).panel, between + (leaf < k ? from_left : from_right));
    }
    for (std::size_t s = 0; s < sums.size(); ++s) sums[s] = sum_.far(s, k, from_left, from_right);
    return line_.combined(slope, sums);
  }

 private:
  static std::vector<hierarchical::LineSum::Kernel> kernels_of(const NodeLine& line) {
    using Kernel = hierarchical::LineSum::Kernel;
    std::vector<Kernel> kernels(line.weights().size(), Kernel::cauchy);
    kernels.back() = Kernel::distance;
    return kernels;
  }

  NodeLine line_;
  hierarchical::LineSum sum_;
};

/// Sums with the weight 1/|Y| (x' - e)^-sigma, where e is the pivot of x's component. The caller also adds the panels
/// of this component.
class PivotedNodes {
 public:
  PivotedNodes(const SignedFundamentalSolution<double>& y, NodeLine line)
      : y_(&y), line_(std::move(line)), sum_(line_.lengths(), line_.sources(), line_.weights()) {
    for (const auto& [first, end] : y.set().runs()) {
      if (y.set().in_contact(first)) components_.push_back({first, end});
    }
  }

  /// As above, with visit(panel, distances of its nearer end from x and from e).
  template <class Visit>
  Estimate<double> around(const std::vector<double>& slope, const SurfacePoint<double>& at, std::size_t component,
                          int sigma, const Visit& visit) const {
    const std::size_t e = y_->pivots()[component].point;
    const NodeLine::Segments& own = components_[component];
    const auto pivot = line_.place(beside(y_->set(), e, y_->set().contact_side(e), 0.0));
    std::vector<double> sums(sum_.sums(), 0);
    sum_.around(
        {line_.place(at), pivot, y_->distance(at, e), sigma}, {line_.first_leaf(own.first), line_.first_leaf(own.end)},
        sums,
        [&](std::size_t leaf, double from_x, double from_pivot) { visit(line_.leaf(leaf).panel, from_x, from_pivot); });
    return line_.combined(slope, sums);
  }
  /// Returns the segments of a component.
  const NodeLine::Segments& segments(std::size_t component) const { return components_[component]; }

 private:
  const SignedFundamentalSolution<double>* y_;
  NodeLine line_;
  std::vector<NodeLine::Segments> components_;
  hierarchical::PivotSum sum_;
};

}  // namespace steadyslide::numeric
