#pragma once
// What the shear t_t = r_k t on many panels does to a place x in or beside one with the ratio r:
//
//   sum_k (r_k - r) (1/pi) int_k t/(x'-x) dx',
//
// in double. Panels that are far from x stand together in cells (numeric/hierarchical/), their sources the nodes of the rules
// by which every method tells its traction (piecewise_traction.hpp): a place costs O(log n). Those that are near are left to
// the caller. A rule is right for functions whose poles are a panel's length away, and a cell is far where that holds.

#include "numeric/cauchy/traction_integrals.hpp"
#include "numeric/hierarchical/cell_moments.hpp"
#include "numeric/solution/piecewise_traction.hpp"

namespace steadyslide::numeric {

class DistantTractions {
 public:
  /// Segment k of the traction is panel k of the density, all lengths `unit` times as long.
  DistantTractions(const PiecewiseDensity<double>& density, const PiecewiseTraction<double>& traction, double unit)
      : DistantTractions(line_of(density, traction, unit)) {}

  /// The sum over far panels, and visit(k, side, distance) for the others, x on that side of panel k. The panel that x is in is
  /// left out: its ratio is r.
  template <class Visit>
  Estimate<double> around(const LinePlace<double>& place, double ratio, const Visit& visit) const;

 private:
  /// Panels and the gaps between them.
  struct Line {
    std::vector<double> lengths;
    std::vector<std::size_t> leaf_of;   ///< by panel
    std::vector<std::size_t> panel_of;  ///< by leaf
    std::vector<hierarchical::Source> sources;
    /// Forces times r_k, forces, and what the sum of both may be wrong by.
    std::vector<std::vector<double>> weights{3};
  };
  static Line line_of(const PiecewiseDensity<double>& density, const PiecewiseTraction<double>& traction, double unit);
  explicit DistantTractions(Line line);
  /// What a cell at this distance, on that side of x, has of the sum.
  Estimate<double> of_cell(std::size_t cell, Side side, double distance, double ratio) const;

  Line line_;
  hierarchical::CellMoments moments_;
};

template <class Visit>
Estimate<double> DistantTractions::around(const LinePlace<double>& place, double ratio, const Visit& visit) const {
  const hierarchical::PanelTree& tree = moments_.tree();
  Estimate<double> sum{0, 0};
  const auto takes = [&](std::size_t cell, Side side, double distance) {
    if (!tree.is_far(cell, distance)) return false;
    sum += of_cell(cell, side, distance, ratio);
    return true;
  };
  const auto near = [&](std::size_t leaf, double distance, Side side) {
    visit(line_.panel_of[leaf], opposite(side), distance);
  };
  if (place.inside) {
    tree.around(line_.leaf_of[place.panels], place.inside->from_left, place.inside->from_right, takes, near);
  } else if (place.panels == 0) {
    tree.beyond(Side::left, place.to_right, takes, near);
  } else if (place.panels == line_.leaf_of.size()) {
    tree.beyond(Side::right, place.to_left, takes, near);
  } else if (const std::size_t before = line_.leaf_of[place.panels - 1]; before + 1 < line_.leaf_of[place.panels]) {
    tree.around(before + 1, place.to_left, place.to_right, takes, near);
  } else {
    // Where two panels meet: the end of the one on the left.
    visit(place.panels - 1, Side::right, 0.0);
    tree.around(before, line_.lengths[before], 0.0, takes, near);
  }
  return sum;
}

}  // namespace steadyslide::numeric
