#pragma once
// Sums over sources c_i on a line at a place x, weighted by the distance of the sources from a pivot e:
//
//   sum_i w_i (c_i - e)^-sigma/(c_i - x),   sigma = 1, 0 or -1.
//
// A cell whose sources are far from both is one series. With D = |c - x|, E = |c - e| from its centre, h its
// half-width, u in [-1, 1] its places, r = +-h/D and q = +-h/E with the sign of x - c, on either side of x and e:
//
//   sigma = 0:   -+(1/D) sum_k r^k u^k,
//   sigma = 1:   1/(D E) sum_k H_k u^k,   H_k = r H_{k-1} + q^k (complete homogeneous polynomials),
//   sigma = -1:  (E/D) (1 + sum_{k>0} r^{k-1} (r - q) u^k).
//
// Nothing cancels, even if x and e are very close, because the difference of 1/(c_i - x) and 1/(c_i - e) is never
// formed. For every cell, the distance is measured from the nearer one of x and e; the other one is farther by |x - e|.
// Sources between x and e must be left out. A place costs O(log n); far means |r|, |q| <= 2/7, so that the rest of a
// series is below 1e-16 of its sizes.

#include "numeric/hierarchical/cell_moments.hpp"

namespace steadyslide::numeric::hierarchical {

class PivotSum {
 public:
  /// Takes sources from left to right; weights[s][i] is the weight of source i in sum number s. The last sum is one of
  /// absolute values: sum_i w_i |c_i - e|^-sigma/|c_i - x|.
  PivotSum(const std::vector<double>& lengths, const std::vector<Source>& sources,
           const std::vector<std::vector<double>>& weights)
      : moments_(lengths, sources, weights), panels_(static_cast<std::ptrdiff_t>(lengths.size())) {}

  std::size_t sums() const { return moments_.sums(); }

  /// A place in a panel or at its ends, or outside the line: then `panel` is -1 or the number of panels.
  struct PanelPoint {
    std::ptrdiff_t panel;
    double from_left;
    double from_right;
  };
  /// The parameters of a sum; `offset` is x - e.
  struct Kernel {
    PanelPoint x;
    PanelPoint pivot;
    double offset;
    int sigma;
  };
  /// The panels first..end-1, which are left out. They include all panels with sources between x and e.
  struct PanelRange {
    std::size_t first;
    std::size_t end;
  };
  /// Adds the contributions of far cells to sums[s]. Calls visit(panel, distances of its nearer end from x and from e)
  /// for near panels that have sources.
  template <class Visit>
  void around(const Kernel& kernel, const PanelRange& without, std::vector<double>& sums, const Visit& visit) const;

 private:
  struct Distances {
    double x;
    double pivot;
  };
  template <class Visit>
  void walk(Side side, const Kernel& kernel, const PanelRange& without, std::vector<double>& sums,
            const Visit& visit) const;
  bool is_far(std::size_t cell, double distance) const {
    return distance > 0 && distance >= 1.25 * moments_.tree().cells()[cell].extent;
  }
  void add(std::size_t cell, Side side, int sigma, const Distances& nearest, std::vector<double>& sums) const;

  CellMoments moments_;
  std::ptrdiff_t panels_;
};

template <class Visit>
void PivotSum::around(const Kernel& kernel, const PanelRange& without, std::vector<double>& sums,
                      const Visit& visit) const {
  walk(Side::left, kernel, without, sums, visit);
  walk(Side::right, kernel, without, sums, visit);
}

template <class Visit>
void PivotSum::walk(Side side, const Kernel& kernel, const PanelRange& without, std::vector<double>& sums,
                    const Visit& visit) const {
  const bool from_x = (kernel.offset < 0) == (side == Side::left);
  const PanelPoint& from = from_x ? kernel.x : kernel.pivot;
  if (from.panel < 0 || from.panel >= panels_) return;  // nothing lies beyond it
  const double between = kernel.offset < 0 ? -kernel.offset : kernel.offset;
  const Distances more{from_x ? 0 : between, from_x ? between : 0};
  const PanelTree& tree = moments_.tree();
  const auto takes = [&](std::size_t cell, Side sources, double distance) {
    const PanelTree::Cell& c = tree.cells()[cell];
    if (sources != side || (c.first >= without.first && c.end <= without.end)) return true;
    const bool is_apart = c.end <= without.first || c.first >= without.end;
    if (!is_apart || !is_far(cell, distance)) return false;
    add(cell, side, kernel.sigma, {distance + more.x, distance + more.pivot}, sums);
    return true;
  };
  tree.around(static_cast<std::size_t>(from.panel), from.from_left, from.from_right, takes,
              [&](std::size_t panel, double gap, Side) { visit(panel, gap + more.x, gap + more.pivot); });
}

}  // namespace steadyslide::numeric::hierarchical
