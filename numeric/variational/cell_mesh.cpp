#include "numeric/variational/cell_mesh.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace steadyslide::numeric::variational {
namespace {

Rational support_length(const ContactProblem& problem) {
  return problem.indenter().right() - problem.indenter().left();
}

/// Distances from 0 of the cells' ends on one side, up to `end`.
std::vector<double> graded_distances(double end, double smallest, double ratio, double largest) {
  std::vector<double> result;
  double distance = 0;
  double length = smallest;
  // The last cell takes up what would be less than half a cell.
  while (distance + 1.5 * length < end) {
    distance += length;
    result.push_back(distance);
    length = std::min(length * ratio, largest);
  }
  result.push_back(end);
  return result;
}

}  // namespace

CellMesh::CellMesh(const ContactProblem& problem, std::size_t cells)
    : frame_{(problem.indenter().left() + problem.indenter().right()) / 2, support_length(problem)},
      edges_(cells + 1),
      uniform_(true),
      length_(1 / static_cast<double>(cells)) {
  for (std::size_t i = 0; i <= cells; ++i) edges_[i] = static_cast<double>(i) / static_cast<double>(cells) - 0.5;
}

CellMesh::CellMesh(const ContactProblem& problem, const Rational& origin, std::vector<double> edges)
    : frame_{origin, support_length(problem)}, edges_(std::move(edges)), uniform_(false) {
  if (edges_.size() < 2 || std::adjacent_find(edges_.begin(), edges_.end(), std::greater_equal<>()) != edges_.end()) {
    throw std::invalid_argument("cell edges do not increase");
  }
}

std::size_t CellMesh::cell_at(double xi) const {
  const auto after = std::upper_bound(edges_.begin() + 1, edges_.end() - 1, xi);
  return static_cast<std::size_t>(after - edges_.begin()) - 1;
}

std::vector<double> graded_edges(double left, double right, double smallest, double ratio, double largest) {
  std::vector<double> edges;
  const std::vector<double> before = graded_distances(-left, smallest, ratio, largest);
  for (auto distance = before.rbegin(); distance != before.rend(); ++distance) edges.push_back(-*distance);
  edges.push_back(0);
  const std::vector<double> after = graded_distances(right, smallest, ratio, largest);
  edges.insert(edges.end(), after.begin(), after.end());
  return edges;
}

}  // namespace steadyslide::numeric::variational
