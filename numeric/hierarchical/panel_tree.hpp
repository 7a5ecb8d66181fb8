#pragma once
// Panels that follow each other on a line, in a binary tree of cells: which cells are so far from which that a few numbers
// stand for all their sources. A cell is cut where its length is halved, so that the pairs that are far from each other
// number O(n) however the lengths are distributed [Callahan and Kosaraju, J. ACM 42 (1995) 67: a fair split tree]; panels
// that grow or shrink geometrically are no exception.
//
// Lengths alone come in, and every distance is a sum of them from the two ends that face each other: between places close
// to each other it is as exact as the lengths, wherever on the line they are.

#include <cstddef>
#include <utility>
#include <vector>

#include "model/direction.hpp"

namespace steadyslide::numeric::hierarchical {

class PanelTree {
 public:
  /// Where a panel's sources begin and end, as distances from its two ends.
  struct Panel {
    double length;
    bool has_sources;
    double before = 0;  ///< from the left end to the first source
    double after = 0;   ///< from the last source to the right end
  };
  struct Cell {
    std::size_t first;  ///< panels first..end-1
    std::size_t end;
    double length;
    bool has_sources = false;
    double before = 0;
    double after = 0;
    double extent = 0;     ///< from the first to the last source
    std::size_t left = 0;  ///< cells; 0 in a leaf, which is one panel
    std::size_t right = 0;
    std::size_t parent = 0;

    bool is_leaf() const { return left == 0; }
  };
  /// Sources that stand together for the places of another cell: on the side `side` of it, the nearest one at this
  /// distance from its end.
  struct Far {
    std::size_t cell;
    Side side;
    double distance;
  };
  /// A panel that has to be looked at source by source: `between` lies between the ends that face each other.
  struct Near {
    std::size_t panel;
    double between;
  };

  explicit PanelTree(const std::vector<Panel>& panels);

  /// Parents stand before their children; the first one is the whole line.
  const std::vector<Cell>& cells() const { return cells_; }
  std::size_t leaf(std::size_t panel) const { return leaves_[panel]; }

  /// For all places of a cell: neither its length nor the extent of the sources is longer than their distance.
  const std::vector<Far>& far_from(std::size_t cell) const { return far_[cell]; }
  /// What no cell around panel k stands for, without the panel itself.
  const std::vector<Near>& near_to(std::size_t panel) const { return near_[panel]; }

  /// The same for one place: takes(cell, side, distance of its nearest source) says whether the cell's sources stand
  /// together; where no cell does, near(panel, distance of its nearer end, side). Panel k itself is left out.
  template <class Takes, class NearVisit>
  void around(std::size_t k, double from_left, double from_right, const Takes& takes, const NearVisit& near) const;
  /// May the sources of a cell stand together for a place at this distance from the nearest one?
  bool is_far(std::size_t cell, double distance) const { return distance > 0 && distance >= cells_[cell].extent; }
  /// At a distance beyond the line, on that side of it.
  template <class Takes, class NearVisit>
  void beyond(Side side, double distance, const Takes& takes, const NearVisit& near) const {
    descend(0, opposite(side), distance, takes, near);
  }

 private:
  std::size_t build(const std::vector<Panel>& panels, std::size_t first, std::size_t end);
  void interact(std::size_t source, std::size_t target, Side side, double gap);
  template <class Takes, class NearVisit>
  void descend(std::size_t cell, Side side, double gap, const Takes& takes, const NearVisit& near) const;

  std::vector<Cell> cells_;
  std::vector<std::size_t> leaves_;
  std::vector<std::vector<Far>> far_;
  std::vector<std::vector<Near>> near_;
};

template <class Takes, class NearVisit>
void PanelTree::around(std::size_t k, double from_left, double from_right, const Takes& takes,
                       const NearVisit& near) const {
  for (std::size_t cell = leaves_[k]; cell != 0; cell = cells_[cell].parent) {
    const Cell& parent = cells_[cells_[cell].parent];
    const bool is_left = parent.left == cell;
    descend(is_left ? parent.right : parent.left, is_left ? Side::right : Side::left, is_left ? from_right : from_left,
            takes, near);
    (is_left ? from_right : from_left) += cells_[is_left ? parent.right : parent.left].length;
  }
}

template <class Takes, class NearVisit>
void PanelTree::descend(std::size_t cell, Side side, double gap, const Takes& takes, const NearVisit& near) const {
  const Cell& c = cells_[cell];
  if (!c.has_sources) return;
  const double distance = gap + (side == Side::left ? c.after : c.before);
  if (takes(cell, side, distance)) return;
  if (c.is_leaf()) return near(c.first, gap, side);
  const auto [nearer, other] = side == Side::left ? std::pair(c.right, c.left) : std::pair(c.left, c.right);
  descend(nearer, side, gap, takes, near);
  descend(other, side, gap + cells_[nearer].length, takes, near);
}

}  // namespace steadyslide::numeric::hierarchical
