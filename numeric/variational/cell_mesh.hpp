#pragma once
// The cells on which the variational solver's traction is constant. Lengths are reduced, xi = (x - origin)/unit, with
// the support's length as unit: then -log|xi - xi'| >= 0 all over the support.

#include <vector>

#include "model/reduced_problem.hpp"
#include "numeric/number/real.hpp"

namespace steadyslide::numeric::variational {

class CellMesh {
 public:
  /// `cells` >= 1 equal cells on the support, xi from -1/2 to 1/2, whatever lies inside.
  CellMesh(const ContactProblem& problem, std::size_t cells);
  /// Cells of any lengths, to be refined towards the place `origin`: xi of their ends, increasing, the first and the
  /// last one are the support's.
  CellMesh(const ContactProblem& problem, const Rational& origin, std::vector<double> edges);

  const Frame& frame() const { return frame_; }
  bool is_uniform() const { return uniform_; }
  std::size_t size() const { return edges_.size() - 1; }
  /// In xi.
  double left(std::size_t i) const { return edges_[i]; }
  double right(std::size_t i) const { return edges_[i + 1]; }
  double length(std::size_t i) const { return uniform_ ? length_ : edges_[i + 1] - edges_[i]; }
  double centre(std::size_t i) const { return (edges_[i] + edges_[i + 1]) / 2; }
  const std::vector<double>& edges() const { return edges_; }
  /// The cell that contains xi: the right one of two that meet there, the nearest one outside the support.
  std::size_t cell_at(double xi) const;
  /// xi of a place of the problem, rounded once.
  double place(const Rational& x) const { return to_real<double>((x - frame_.origin) / frame_.unit); }

 private:
  Frame frame_;
  std::vector<double> edges_;
  bool uniform_;
  double length_ = 0;
};

/// Edges for a mesh refined towards xi = 0, in proportion to the distance from it: the cells next to 0 have the length
/// `smallest`, each further one is `ratio` > 1 times as long as the one before it until `largest`. To both sides.
std::vector<double> graded_edges(double left, double right, double smallest, double ratio, double largest);

}  // namespace steadyslide::numeric::variational
