#include "model/surface_mesh.hpp"

#include "model/invalid_data.hpp"

namespace steadyslide {

SurfaceMesh::SurfaceMesh(std::vector<Rational> nodes, int order) : nodes_(std::move(nodes)), order_(order) {
  if (order != 1 && order != 2) {
    throw InvalidData("order", "wrong order", "elements are of order 1 or 2", std::to_string(order));
  }
  const auto step = static_cast<std::size_t>(order);
  if (nodes_.size() < step + 1 || (nodes_.size() - 1) % step != 0) {
    throw InvalidData("nodes", "wrong number of nodes", "a mesh of N elements of order n has n N + 1 nodes",
                      std::to_string(nodes_.size()) + " nodes of order " + std::to_string(order));
  }
  const auto field = [](std::size_t i) { return "nodes[" + std::to_string(i) + "]"; };
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    if (nodes_[i] > nodes_[i - 1]) continue;
    throw InvalidData(field(i), "not increasing", "x increases from node to node",
                      to_string(nodes_[i]) + " after " + to_string(nodes_[i - 1]));
  }
  for (std::size_t i = 1; order == 2 && i < nodes_.size(); i += 2) {
    if (nodes_[i] * 2 == nodes_[i - 1] + nodes_[i + 1]) continue;
    throw InvalidData(field(i), "node off the middle", "every second node is exactly in the middle of its element",
                      to_string(nodes_[i]));
  }
}

}  // namespace steadyslide
