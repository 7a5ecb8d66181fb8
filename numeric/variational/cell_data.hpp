#pragma once
// What the cells see of a problem, by exact integration also where a jump of friction or a break of the profile falls
// inside a cell.

#include <vector>

#include "numeric/variational/cell_mesh.hpp"

namespace steadyslide::numeric::variational {

/// Integrals of s over each cell.
struct CellFriction {
  std::vector<double> whole;  ///< int s
  /// Mean over x in the cell of int s from its left end to x, or from x to its right end where s is negative: what a
  /// traction on the cell adds to its own mean displacement.
  std::vector<double> own;
  /// +1: s >= 0, and the displacement counts from the left end of the support. -1: s <= 0 somewhere, and it counts from
  /// the right end: no friction then lowers the surface, and the indenter's approach takes up the difference.
  int sign = 1;
};
CellFriction cell_friction(const ContactProblem& problem, const CellMesh& mesh);

/// psi(x) less its value at the middle of the support: only differences matter, and these are small near the contact.
Rational profile_above_middle(const ContactProblem& problem, const Rational& x);

/// Means of profile_above_middle/(c P) over each cell.
std::vector<double> cell_profile(const ContactProblem& problem, const CellMesh& mesh);

}  // namespace steadyslide::numeric::variational
