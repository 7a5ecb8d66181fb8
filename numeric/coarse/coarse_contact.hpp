#pragma once
// Where is the contact, roughly? A small variational solution that knows no exponents: piecewise constant traction on
// cells cut at every jump of friction and break of the profile, Galerkin's equations with the kernel of
//
//   u(x)/c = -(1/pi) int t(x') log|x - x'| dx' + int_left^x s t,      u/c + C <= psi/c, t <= 0, t (u/c + C - psi/c) = 0
//
// at one point of each cell, int t = -P; an active-set method with dense LU; cells refined where contact may begin or
// end until every contact component has several. [Bal16, section 3.1]

#include <optional>
#include <vector>

#include "model/contact_problem.hpp"
#include "numeric/solution/contact_interval.hpp"

namespace steadyslide::numeric {

/// Lengths are measured from `origin`, which is exact.
struct CoarseContact {
  Rational origin;
  std::vector<ContactInterval> zones;  ///< left to right
  double tilt = 0;                     ///< slope added to psi/c: not zero only with load_at
  std::vector<double> cell_edges;      ///< of the last mesh
  std::vector<double> traction;        ///< one per cell
  bool converged = true;               ///< false: the active sets cycled; the best one is given
};

/// About `cells` cells to begin with, at most 16 times as many on the last mesh.
CoarseContact coarse_contact(const ContactProblem& problem, int cells);

}  // namespace steadyslide::numeric
