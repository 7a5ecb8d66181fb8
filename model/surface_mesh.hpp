#pragma once
// A mesh of the surface as a finite element code has it: linear elements with nodes at their ends, or quadratic ones with a
// third node in their middle.

#include <vector>

#include "model/rational.hpp"

namespace steadyslide {

class SurfaceMesh {
 public:
  /// Throws InvalidData of "order" unless it is 1 or 2; of "nodes" unless there are order n + 1 of them, n >= 1; and of
  /// "nodes[i]" unless they increase and every second one of order 2 is exactly in the middle.
  SurfaceMesh(std::vector<Rational> nodes, int order);

  const std::vector<Rational>& nodes() const { return nodes_; }
  int order() const { return order_; }
  std::size_t elements() const { return (nodes_.size() - 1) / static_cast<std::size_t>(order_); }
  /// The first node of an element, or the last one of all.
  std::size_t first_node(std::size_t element) const { return element * static_cast<std::size_t>(order_); }

 private:
  std::vector<Rational> nodes_;
  int order_;
};

}  // namespace steadyslide
