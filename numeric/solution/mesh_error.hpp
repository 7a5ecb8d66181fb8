#pragma once
// The error of a number that is computed on nested meshes, each half as fine as the one before.
//
// An error of c/N^q makes differences of two neighbouring meshes of (2^q - 1) c/N^q, which grow by 2^q from mesh to mesh.
// A single difference may be small by chance, because ends and jumps lie at varying positions in their cells. So three
// differences are reduced to the finest mesh. The error is three times the largest one.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

/// Returns the numbers `evaluate(mesh)` of the first mesh, a list of estimates, with the errors that the other meshes
/// show. `rate` is q.
template <class Mesh, class Evaluate>
auto on_nested_meshes(std::span<const Mesh> meshes, Evaluate evaluate, double rate) {
  auto result = evaluate(meshes.front());
  auto last = result, largest = result;
  for (auto& number : largest) number.error = 0;
  const double growth = std::exp2(rate);
  double weight = 3 / (growth - 1);
  for (std::size_t k = 1; k < std::min<std::size_t>(meshes.size(), 4); ++k, weight /= growth) {
    auto next = evaluate(meshes[k]);
    for (std::size_t i = 0; i < result.size(); ++i) {
      const auto difference = weight * abs(next[i].value - last[i].value);
      if (difference > largest[i].error) largest[i].error = difference;
    }
    last = std::move(next);
  }
  for (std::size_t i = 0; i < result.size(); ++i) result[i].error += largest[i].error;
  return result;
}

}  // namespace steadyslide::numeric
