#pragma once
// int eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x) over those panels of a contact that are far from x, for many x and k, by cells
// (numeric/hierarchical/), in double. Panels near to x are left to the caller.

#include "numeric/hierarchical/line_sum.hpp"
#include "numeric/hierarchical/pivot_sum.hpp"
#include "numeric/riemann_hilbert/node_line.hpp"

namespace steadyslide::numeric {

/// One weight for all places.
class DistantNodes {
 public:
  explicit DistantNodes(NodeLine line);

  /// The sum over far panels, g_k by its coefficients, and visit(panel, distance of its nearer end) for the others; those
  /// of the segment where x is are left out. The error is in units of 4 epsilon.
  template <class Visit>
  Estimate<double> around(const std::vector<double>& slope, const SurfacePoint<double>& at, const Visit& visit) const;

 private:
  NodeLine line_;
  hierarchical::LineSum sum_;
};

/// The weight 1/|Y| (x' - e)^-sigma with the pivot e of the component that x belongs to: its own panels are left to the
/// caller, too.
class PivotedNodes {
 public:
  PivotedNodes(const SignedFundamentalSolution<double>& y, NodeLine line);

  /// As above; visit(panel, distances of its nearer end from x and from e).
  template <class Visit>
  Estimate<double> around(const std::vector<double>& slope, const SurfacePoint<double>& at, std::size_t component,
                          int sigma, const Visit& visit) const;
  /// The segments of a component.
  const NodeLine::Segments& segments(std::size_t component) const { return components_[component]; }

 private:
  hierarchical::PivotSum::Place place(const SurfacePoint<double>& at) const;

  const SignedFundamentalSolution<double>* y_;
  NodeLine line_;
  std::vector<NodeLine::Segments> components_;
  hierarchical::PivotSum sum_;
};

template <class Visit>
Estimate<double> DistantNodes::around(const std::vector<double>& slope, const SurfacePoint<double>& at,
                                      const Visit& visit) const {
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
  const auto [k, from_left, from_right] = line_.place(at);
  for (const auto& [leaf, between] : sum_.near_to(k)) {
    if (line_.leaf(leaf).part.segment != line_.leaf(k).part.segment)
      visit(line_.leaf(leaf).panel, between + (leaf < k ? from_left : from_right));
  }
  for (std::size_t s = 0; s < sums.size(); ++s) sums[s] = sum_.far(s, k, from_left, from_right);
  return line_.combined(slope, sums);
}

template <class Visit>
Estimate<double> PivotedNodes::around(const std::vector<double>& slope, const SurfacePoint<double>& at,
                                      std::size_t component, int sigma, const Visit& visit) const {
  const std::size_t e = y_->pivots()[component].point;
  const NodeLine::Segments& own = components_[component];
  const hierarchical::PivotSum::Kernel kernel{place(at), place(beside(y_->set(), e, y_->set().contact_side(e), 0.0)),
                                              y_->distance(at, e), sigma};
  std::vector<double> sums(sum_.sums(), 0);
  sum_.around(
      kernel, {line_.first_leaf(own.first), line_.first_leaf(own.end)}, sums,
      [&](std::size_t leaf, double from_x, double from_pivot) { visit(line_.leaf(leaf).panel, from_x, from_pivot); });
  return line_.combined(slope, sums);
}

}  // namespace steadyslide::numeric
