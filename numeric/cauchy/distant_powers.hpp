#pragma once
// The logarithm of prod_j |x - e_j|^{p_j} over the points e_j that are far from x, by cells (numeric/hierarchical/), for the
// fundamental solution of many points in double. The points near to x are left to the caller.

#include "numeric/hierarchical/line_sum.hpp"
#include "numeric/number/node.hpp"
#include "numeric/number/power.hpp"

namespace steadyslide::numeric {

class DistantPowers {
 public:
  /// Panels that follow each other, with one power more.
  DistantPowers(const std::vector<Panel<double>>& panels, const std::vector<Power<double>>& powers);

  /// At a place of panel k, its ends included: the sum over the far points, and visit(j, |e_j - x|) for the others.
  template <class Visit>
  double around(std::size_t k, double from_left, double from_right, const Visit& visit) const;
  /// The same at the distance beyond the first point, or the last one, which is among the points visited.
  template <class Visit>
  double beyond(Side side, double distance, const Visit& visit) const;

  /// An estimate of the sum's rounding error on panel k, over epsilon.
  double rounding(std::size_t k) const;

 private:
  /// visit() for what panel k has of the points: its left end, and the last one.
  template <class Visit>
  void visit_panel(std::size_t k, double from_left, double from_right, const Visit& visit) const {
    visit(k, from_left);
    if (k + 1 == lengths_.size()) visit(k + 1, from_right);
  }

  std::vector<double> lengths_;
  double size_ = 0;  ///< sum |p_j|
  double hull_ = 0;
  hierarchical::LineSum sum_;
};

template <class Visit>
double DistantPowers::around(std::size_t k, double from_left, double from_right, const Visit& visit) const {
  visit_panel(k, from_left, from_right, visit);
  for (const auto& [panel, between] : sum_.near_to(k)) {
    const double length = lengths_[panel];
    if (panel < k) {
      visit_panel(panel, from_left + between + length, from_left + between, visit);
    } else {
      visit_panel(panel, from_right + between, from_right + between + length, visit);
    }
  }
  return sum_.far(0, k, from_left, from_right);
}

template <class Visit>
double DistantPowers::beyond(Side side, double distance, const Visit& visit) const {
  double sum = 0;
  const hierarchical::PanelTree& tree = sum_.tree();
  const auto takes = [&](std::size_t cell, Side sources, double from_here) {
    const hierarchical::PanelTree::Cell& c = tree.cells()[cell];
    const bool has_end = side == Side::left ? c.first == 0 : c.end == lengths_.size();
    if (has_end || c.is_leaf() || !tree.is_far(cell, from_here)) return false;
    sum += sum_.of_cell(0, cell, sources, from_here);
    return true;
  };
  tree.beyond(side, distance, takes, [&](std::size_t panel, double gap, Side sources) {
    const double other = gap + lengths_[panel];
    visit_panel(panel, sources == Side::right ? gap : other, sources == Side::right ? other : gap, visit);
  });
  return sum;
}

}  // namespace steadyslide::numeric
