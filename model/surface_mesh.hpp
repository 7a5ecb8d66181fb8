#pragma once
// A mesh of the surface as a finite element code has it: linear elements with nodes at their ends, or quadratic ones
// with a third node in their middle.

#include <vector>

#include "model/rational.hpp"

namespace steadyslide {

class SurfaceMesh {
 public:
  /// Throws InvalidData with field "order" unless it is 1 or 2; with field "nodes" unless there are order n + 1 nodes,
  /// n >= 1; with field "nodes[i]" unless the nodes increase and, for order 2, every second one is exactly in the
  /// middle of its element.
  SurfaceMesh(std::vector<Rational> nodes, int order);

  const std::vector<Rational>& nodes() const { return nodes_; }
  int order() const { return order_; }
  std::size_t elements() const { return (nodes_.size() - 1) / static_cast<std::size_t>(order_); }
  /// Returns the first node of an element; for element = number of elements, the last node.
  std::size_t first_node(std::size_t element) const { return element * static_cast<std::size_t>(order_); }

 private:
  std::vector<Rational> nodes_;
  int order_;
};

}  // namespace steadyslide
