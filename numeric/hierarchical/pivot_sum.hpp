#pragma once
// Sums over sources c_i on a line as seen from a place x, weighted by their distance from a pivot e:
//
//   sum_i w_i (c_i - e)^-sigma/(c_i - x),   sigma = 1, 0 or -1.
//
// A cell whose sources are far from both is one series. With D = |c - x|, E = |c - e| from its centre, h its half-width,
// u in [-1, 1] its places, r = +-h/D and q = +-h/E with the sign of x - c, on either side of x and e:
//
//   sigma = 0:   -+(1/D) sum_k r^k u^k,
//   sigma = 1:   1/(D E) sum_k H_k u^k,   H_k = r H_{k-1} + q^k (complete homogeneous polynomials),
//   sigma = -1:  (E/D) (1 + sum_{k>0} r^{k-1} (r - q) u^k).
//
// Nothing cancels: the difference of 1/(c_i - x) and 1/(c_i - e) is never formed, however close x and e are. Every cell is
// seen from the one of both that is nearer, and the other one is farther away by |x - e|. Sources between x and e have to be
// left out. A place costs O(log n); far means |r|, |q| <= 2/7, so that the rest of a series is below 1e-16 of its sizes.

#include "numeric/hierarchical/cell_moments.hpp"

namespace steadyslide::numeric::hierarchical {

class PivotSum {
 public:
  /// Sources from left to right; weights[s][i] is that of source i in sum number s. The last sum is one of sizes:
  /// sum_i w_i |c_i - e|^-sigma/|c_i - x|.
  PivotSum(const std::vector<double>& lengths, const std::vector<Source>& sources,
           const std::vector<std::vector<double>>& weights)
      : moments_(lengths, sources, weights), panels_(static_cast<std::ptrdiff_t>(lengths.size())) {}

  std::size_t sums() const { return moments_.sums(); }

  /// In a panel, its ends included, or off the line: panel -1, or the number of panels.
  struct Place {
    std::ptrdiff_t panel;
    double from_left;
    double from_right;
  };
  /// What a sum is taken for; `offset` is x - e.
  struct Kernel {
    Place x;
    Place pivot;
    double offset;
    int sigma;
  };
  /// Panels first..end-1, which are left out: all those that have sources between x and e are among them.
  struct Range {
    std::size_t first;
    std::size_t end;
  };
  /// Adds to sums[s] what cells far away have, and calls visit(panel, distances of its nearer end from x and from e)
  /// for panels that are near, if they have sources.
  template <class Visit>
  void around(const Kernel& kernel, const Range& without, std::vector<double>& sums, const Visit& visit) const;

 private:
  struct Distances {
    double x;
    double pivot;
  };
  template <class Visit>
  void walk(Side side, const Kernel& kernel, const Range& without, std::vector<double>& sums, const Visit& visit) const;
  bool is_far(std::size_t cell, double distance) const {
    return distance > 0 && distance >= 1.25 * moments_.tree().cells()[cell].extent;
  }
  void add(std::size_t cell, Side side, int sigma, const Distances& nearest, std::vector<double>& sums) const;

  CellMoments moments_;
  std::ptrdiff_t panels_;
};

template <class Visit>
void PivotSum::around(const Kernel& kernel, const Range& without, std::vector<double>& sums, const Visit& visit) const {
  walk(Side::left, kernel, without, sums, visit);
  walk(Side::right, kernel, without, sums, visit);
}

template <class Visit>
void PivotSum::walk(Side side, const Kernel& kernel, const Range& without, std::vector<double>& sums,
                    const Visit& visit) const {
  const bool from_x = (kernel.offset < 0) == (side == Side::left);
  const Place& from = from_x ? kernel.x : kernel.pivot;
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
