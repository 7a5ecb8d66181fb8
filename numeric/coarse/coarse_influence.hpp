#pragma once
// What a force on one cell does to the gap at the points of all cells.
//
//   gap_i = psi_i - C + tilt x_i + sum_j G_ij q_j,   G_ij = -mean_j log|x_i - x'|/pi + int_left^{x_i} s over cell j
//
// q_j >= 0 is the force on cell j, spread evenly over it. The point x_i divides its cell as 1/2 + alpha : 1/2 - alpha:
// with the mean over the cell instead, or its centre, strong friction (s > 2, say) makes the cells next to a
// concentrated force ring and lose contact, as the trapezoidal rule does with a stiff equation; towards s = +-infinity
// this point is the implicit Euler rule.

#include <vector>

#include "numeric/coarse/coarse_mesh.hpp"

namespace steadyslide::numeric::coarse {

class Influence {
 public:
  explicit Influence(const Mesh& mesh);

  const Mesh& mesh() const { return mesh_; }
  std::size_t size() const { return points_.size(); }
  double point(std::size_t i) const { return points_[i]; }
  double profile(std::size_t i) const { return profile_[i]; }
  /// G_ij for all i. Computed when first asked for: most cells never carry a force.
  const double* column(std::size_t j);

 private:
  void compute(std::size_t j, double* column) const;

  const Mesh& mesh_;
  std::vector<double> points_;
  std::vector<double> profile_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace steadyslide::numeric::coarse
