#include "model/surface_mesh.hpp"

#include "broken_rule.hpp"

TEST_CASE("a mesh is nodes that increase, with midside nodes in the middle") {
  const SurfaceMesh mesh({-1, -0.5_r, 0, 1_r / 6, 1_r / 3}, 2);
  CHECK(mesh.elements() == 2);
  CHECK(mesh.first_node(1) == 2);
  CHECK(mesh.first_node(2) == 4);
  CHECK(SurfaceMesh({0, 1}, 1).elements() == 1);
  const auto said = [](const std::vector<Rational>& nodes, int order) {
    return refusal([&] { SurfaceMesh(nodes, order); });
  };
  CHECK(said({0, 1}, 3) == "order: wrong order; elements are of order 1 or 2; 3");
  CHECK(said({}, 1) ==
        "nodes: wrong number of nodes; a mesh of N elements of order n has n N + 1 nodes; 0 nodes of order 1");
  CHECK(said({0, 1, 2, 3}, 2) ==
        "nodes: wrong number of nodes; a mesh of N elements of order n has n N + 1 nodes; 4 nodes of order 2");
  CHECK(said({0, 1, 1}, 1) == "nodes[2]: not increasing; x increases from node to node; 1 after 1");
  CHECK(said({0, 0.4_r, 1}, 2) ==
        "nodes[1]: node off the middle; every second node is exactly in the middle of its element; 0.4");
}
