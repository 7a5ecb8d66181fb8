#include "numeric/hierarchical/panel_tree.hpp"

#include <algorithm>

namespace steadyslide::numeric::hierarchical {
namespace {

/// Returns the panel at which first..end-1 are divided into two halves of about the same length.
std::size_t middle(const std::vector<PanelTree::Panel>& panels, std::size_t first, std::size_t end) {
  double left = panels[first++].length;
  double right = panels[--end].length;
  while (first < end) {
    if (left <= right) {
      left += panels[first++].length;
    } else {
      right += panels[--end].length;
    }
  }
  return first;
}

}  // namespace

PanelTree::PanelTree(const std::vector<Panel>& panels) : leaves_(panels.size()), near_(panels.size()) {
  cells_.reserve(2 * panels.size());
  build(panels, 0, panels.size());
  far_.resize(cells_.size());
  for (const Cell& cell : cells_) {
    if (cell.is_leaf()) continue;
    interact(cell.left, cell.right, Side::left, 0);
    interact(cell.right, cell.left, Side::right, 0);
  }
}

std::size_t PanelTree::build(const std::vector<Panel>& panels, std::size_t first, std::size_t end) {
  const std::size_t index = cells_.size();
  cells_.push_back({first, end, 0});
  if (end - first == 1) {
    const Panel& panel = panels[first];
    Cell& cell = cells_[index];
    cell.length = panel.length;
    cell.has_sources = panel.has_sources;
    cell.before = panel.before;
    cell.after = panel.after;
    cell.extent = std::max(panel.length - panel.before - panel.after, 0.0);
    leaves_[first] = index;
    return index;
  }
  const std::size_t cut = middle(panels, first, end);
  const std::size_t left = build(panels, first, cut);
  const std::size_t right = build(panels, cut, end);
  cells_[left].parent = cells_[right].parent = index;
  const Cell& a = cells_[left];
  const Cell& b = cells_[right];
  Cell& cell = cells_[index];
  cell.left = left;
  cell.right = right;
  cell.length = a.length + b.length;
  cell.has_sources = a.has_sources || b.has_sources;
  cell.before = a.has_sources ? a.before : a.length + b.before;
  cell.after = b.has_sources ? b.after : b.length + a.after;
  cell.extent = a.has_sources && b.has_sources ? a.extent + a.after + b.before + b.extent
                : a.has_sources                ? a.extent
                                               : b.extent;
  return index;
}

void PanelTree::interact(std::size_t source, std::size_t target, Side side, double gap) {
  const Cell& s = cells_[source];
  const Cell& t = cells_[target];
  if (!s.has_sources) return;
  const bool on_left = side == Side::left;
  const double distance = gap + (on_left ? s.after : s.before);
  if (distance > 0 && distance >= std::max(s.extent, t.length)) {
    far_[target].push_back({source, side, distance});
  } else if (s.is_leaf() && t.is_leaf()) {
    near_[t.first].push_back({s.first, gap});
  } else if (t.is_leaf() || (!s.is_leaf() && s.extent > t.length)) {
    const std::size_t nearer = on_left ? s.right : s.left;
    interact(nearer, target, side, gap);
    interact(on_left ? s.left : s.right, target, side, gap + cells_[nearer].length);
  } else {
    const std::size_t nearer = on_left ? t.left : t.right;
    interact(source, nearer, side, gap);
    interact(source, on_left ? t.right : t.left, side, gap + cells_[nearer].length);
  }
}

}  // namespace steadyslide::numeric::hierarchical
