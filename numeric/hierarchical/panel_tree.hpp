#pragma once
// A binary tree of cells over adjacent panels on a line. It finds the pairs of cells that are so far from each other
// that a few numbers can represent all sources of a cell. A cell is divided at half its length, so that there are O(n)
// far pairs for any distribution of lengths [Callahan and Kosaraju, J. ACM 42 (1995) 67: a fair split tree], also for
// panels that grow or shrink geometrically.
//
// The input is lengths only. Every distance is the sum of the lengths in between. So the distance of two close places
// is as accurate as the lengths, anywhere on the line.

#include <cstddef>
#include <utility>
#include <vector>

#include "model/direction.hpp"

namespace steadyslide::numeric::hierarchical {

class PanelTree {
 public:
  /// The extent of a panel's sources, as distances from its two ends.
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
    std::size_t left = 0;  ///< cells; 0 in a leaf, which has one panel
    std::size_t right = 0;
    std::size_t parent = 0;

    bool is_leaf() const { return left == 0; }
  };
  /// A cell whose sources are summed together for all places of another cell. They are on the side `side` of that cell;
  /// the nearest source has this distance from its end.
  struct Far {
    std::size_t cell;
    Side side;
    double distance;
  };
  /// A panel whose sources must be summed one by one. `between` is the distance between the facing ends.
  struct Near {
    std::size_t panel;
    double between;
  };

  explicit PanelTree(const std::vector<Panel>& panels);

  /// Parents come before their children. The first cell is the whole line.
  const std::vector<Cell>& cells() const { return cells_; }
  std::size_t leaf(std::size_t panel) const { return leaves_[panel]; }

  /// Returns the far cells for all places of a cell: neither its length nor the extent of their sources exceeds the
  /// distance.
  const std::vector<Far>& far_from(std::size_t cell) const { return far_[cell]; }
  /// Returns the panels that no far cell contains, without the panel itself.
  const std::vector<Near>& near_to(std::size_t panel) const { return near_[panel]; }

  /// The same for one place, which has these distances from the ends of panel k. takes(cell, side, distance of its
  /// nearest source) returns true if it handles the cell's sources together. For panels in no such cell it calls
  /// near(panel, distance of its nearer end, side). Panel k itself is left out.
  template <class Takes, class NearVisit>
  void around(std::size_t k, double from_left, double from_right, const Takes& takes, const NearVisit& near) const;
  /// True if the sources of a cell may be summed together for a place at this distance from the nearest one.
  bool is_far(std::size_t cell, double distance) const { return distance > 0 && distance >= cells_[cell].extent; }
  /// The same for a place at a distance beyond the line, on that side of it.
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
