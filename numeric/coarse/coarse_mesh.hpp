#pragma once
// The cells of the coarse solution: each lies under one friction value and one piece of the profile. What a force on
// one cell does to the gap at the points of all cells:
//
//   gap_i = psi_i - C + tilt x_i + sum_j G_ij q_j,   G_ij = -mean_j log|x_i - x'|/pi + int_left^{x_i} s over cell j
//
// q_j >= 0 is the force on cell j, spread evenly over it. The point x_i divides its cell as 1/2 + alpha : 1/2 - alpha:
// with the mean over the cell instead, or its centre, strong friction (s > 2, say) makes the cells next to a
// concentrated force ring and lose contact, as the trapezoidal rule does with a stiff equation; towards s = +-infinity
// this point is the implicit Euler rule.

#include <vector>

#include "model/contact_problem.hpp"
#include "numeric/number/polynomial.hpp"

namespace steadyslide::numeric::coarse {

/// The support between two neighbouring cuts: jumps of friction and breaks of the profile. Lengths from the origin.
struct SupportPiece {
  double left;
  double right;
  double s;
  double ahead;                 ///< 1/2 + alpha, the part of a cell left of its point
  double behind;                ///< 1/2 - alpha, the part right of it, formed without subtraction
  std::vector<double> profile;  ///< psi/c, coefficients of 1, x, x^2, ...
  int step;                     ///< the sign of psi(x+) - psi(x-) at `left`

  double profile_at(double x) const { return value_of(profile, x); }
};

class Mesh {
 public:
  /// About `cells` cells of like length, two or more a piece as long as that stays affordable.
  Mesh(const ContactProblem& problem, const Rational& origin, int cells);
  /// Every cell cut into pieces[i] >= 1 equal parts.
  Mesh refined(const std::vector<int>& pieces) const;

  std::size_t size() const { return piece_of_.size(); }
  const std::vector<double>& edges() const { return edges_; }
  double left(std::size_t i) const { return edges_[i]; }
  double right(std::size_t i) const { return edges_[i + 1]; }
  double length(std::size_t i) const { return edges_[i + 1] - edges_[i]; }
  double centre(std::size_t i) const { return (edges_[i] + edges_[i + 1]) / 2; }
  const SupportPiece& piece(std::size_t i) const { return pieces_[piece_of_[i]]; }
  /// Where the displacement in cell i is looked at: the centre without friction, close to the right end for s -> inf.
  double point(std::size_t i) const { return edges_[i] + piece(i).ahead * length(i); }
  /// psi/c at that point.
  double profile(std::size_t i) const { return piece(i).profile_at(point(i)); }
  /// G_ij for all i. Computed when first asked for: most cells never carry a force.
  const double* column(std::size_t j) const;
  /// The cell is the first or the last one of its piece.
  bool beside_cut(std::size_t i) const;
  /// The sign of the step at the left end of cell i; 0 within a piece.
  int step_before(std::size_t i) const;

 private:
  Mesh() = default;

  std::vector<SupportPiece> pieces_;
  std::vector<double> edges_;
  std::vector<std::size_t> piece_of_;
  mutable std::vector<std::vector<double>> columns_;
};

}  // namespace steadyslide::numeric::coarse
