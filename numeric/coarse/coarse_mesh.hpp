#pragma once
// The cells of the coarse solution: each lies under one friction value and one piece of the profile.

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
  /// The cell is the first or the last one of its piece.
  bool beside_cut(std::size_t i) const;
  /// The sign of the step at the left end of cell i; 0 within a piece.
  int step_before(std::size_t i) const;

 private:
  Mesh() = default;

  std::vector<SupportPiece> pieces_;
  std::vector<double> edges_;
  std::vector<std::size_t> piece_of_;
};

}  // namespace steadyslide::numeric::coarse
