#pragma once
// The error of a number that is computed on nested meshes, each half as fine as the one before.
//
// The difference of two meshes shows the error. But a single difference may be small by chance, because ends and jumps
// lie at varying positions in their cells. So all differences are added, each reduced to the finest mesh, and doubled, or multiplied by another `factor`. An
// error of 1/N, as loads may have, doubles from mesh to mesh. With this `growth` the sum of m differences is 2m times
// such an error, and 6 (2^m - 1) times an error of 1/N^2. Integrals with a smooth kernel have errors between 1/N and
// 1/N^2: on 7,200 random points of the body the growth 3 covers all von Mises stresses and all but 5 in 10,000
// components, by a factor of 14 in the median.

#include <cstddef>
#include <span>
#include <utility>

#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

/// Returns the numbers `evaluate(mesh)` of the first mesh, a list of estimates, with the errors that the other meshes
/// show.
template <class Mesh, class Evaluate>
auto on_nested_meshes(std::span<const Mesh> meshes, Evaluate evaluate, double growth = 3, double factor = 2) {
  auto result = evaluate(meshes.front());
  auto last = result;
  double weight = factor;
  for (std::size_t k = 1; k < meshes.size(); ++k, weight /= growth) {
    auto next = evaluate(meshes[k]);
    for (std::size_t i = 0; i < result.size(); ++i) result[i].error += weight * abs(next[i].value - last[i].value);
    last = std::move(next);
  }
  return result;
}

}  // namespace steadyslide::numeric
