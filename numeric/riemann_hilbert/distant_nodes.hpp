#pragma once
// int eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x) over those panels of a contact that are far from x, for many x and k, by cells
// (numeric/hierarchical/), in double. With the rule's nodes x_i, weights w_i of either sign and g_k = sum_m a_m x^m it is
//
//   F[w g] - sum_m a_m F[w x^m],   F[v] = sum_i v_i/(x_i - x),
//
// a difference of sums that are as large as w g, while w (g - g_k) may be small: its error is counted as that of
// sum_i |w_i| (max |g| + sum_m |a_m| max |x|^m)/|x_i - x|. Panels near to x are left to the caller.

#include "numeric/hierarchical/line_sum.hpp"
#include "numeric/riemann_hilbert/jacobi_panels.hpp"

namespace steadyslide::numeric {

class DistantNodes {
 public:
  /// Panels from left to right, all of segments in contact, with the index of each one's first node.
  struct Panels {
    std::vector<SegmentPart<double>> parts;
    std::vector<std::size_t> first_node;
  };
  DistantNodes(const SignedFundamentalSolution<double>& y, const Panels& panels,
               const std::vector<SurfacePoint<double>>& nodes, const std::vector<double>& weights);

  /// The sum over far panels, g_k by its coefficients, and visit(panel, distance of its nearer end) for the others; those
  /// of the segment where x is are left out. The error is in units of 4 epsilon.
  template <class Visit>
  Estimate<double> around(const std::vector<double>& slope, const SurfacePoint<double>& at, const Visit& visit) const;

 private:
  /// Of the tree: a panel of the contact, or a segment without contact.
  struct Leaf {
    std::size_t segment;
    double from_left;
    double length;
    double from_right;
    std::size_t panel;
  };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// The distances of a place from the ends of its part of a segment.
  static std::pair<double, double> within(const SegmentPart<double>& part, const Node<double>& node);
  hierarchical::LineSum sum_over(const SignedFundamentalSolution<double>& y, const Panels& panels,
                                 const std::vector<SurfacePoint<double>>& nodes, const std::vector<double>& weights);
  std::size_t leaf_at(const SurfacePoint<double>& at) const;
  Estimate<double> combined(const std::vector<double>& slope, const std::vector<double>& sums) const;

  std::vector<Leaf> leaves_;
  std::vector<std::size_t> first_leaf_;  ///< of each segment, and one more
  double largest_slope_ = 0;
  double largest_place_ = 0;
  hierarchical::LineSum sum_;
};

template <class Visit>
Estimate<double> DistantNodes::around(const std::vector<double>& slope, const SurfacePoint<double>& at,
                                      const Visit& visit) const {
  std::vector<double> sums(sum_.sums(), 0);
  const bool on_left = at.segment < 0;
  if (on_left || static_cast<std::size_t>(at.segment) + 1 >= first_leaf_.size()) {
    const auto takes = [&](std::size_t cell, Side side, double distance) {
      if (!sum_.tree().is_far(cell, distance)) return false;
      for (std::size_t s = 0; s < sums.size(); ++s) sums[s] += sum_.of_cell(s, cell, side, distance);
      return true;
    };
    const auto near = [&](std::size_t leaf, double gap, Side) { visit(leaves_[leaf].panel, gap); };
    sum_.tree().beyond(on_left ? Side::left : Side::right, on_left ? at.node.from_right : at.node.from_left, takes,
                       near);
    return combined(slope, sums);
  }
  const std::size_t k = leaf_at(at);
  const Leaf& own = leaves_[k];
  const auto [from_left, from_right] = within({own.segment, own.from_left, own.length, own.from_right}, at.node);
  for (const auto& [leaf, between] : sum_.near_to(k)) {
    if (leaves_[leaf].segment != own.segment) visit(leaves_[leaf].panel, between + (leaf < k ? from_left : from_right));
  }
  for (std::size_t s = 0; s < sums.size(); ++s) sums[s] = sum_.far(s, k, from_left, from_right);
  return combined(slope, sums);
}

}  // namespace steadyslide::numeric
