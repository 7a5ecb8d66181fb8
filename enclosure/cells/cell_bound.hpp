#pragma once
// How far pressures on equal cells are from the solution, proved, where s = +-gamma f nowhere falls towards +x and
// the profile has no step.
//
// Pressures p = -t push the surface down by -u = c B p, B p = -(1/pi) int p(x') log|x-x'| dx' + int_left^x s p, up to a
// constant. Let p >= 0 be a solution of finite energy (one exists: [Bal16, theorem 1]), its gap G = psi/c + B p - C >= 0,
// int p = P, int G p = 0. Let p_h >= 0 be any pressures with int p_h = P, and G_h = psi/c + B p_h - C_h >= 0 at every place
// of the support. Then d = p - p_h has no resultant, D(x) = int_left^x d vanishes at both ends, and
//
//   int d B d = int (p - p_h)(G - G_h) = int G_h p_h - int G p_h - int G_h p  <=  int G_h p_h,
//   int d B d = b_0(d, d) + (1/2) sum_k [s_k] D(c_k)^2,   b_0(d, d) = -(1/pi) int int d d log|x-x'| >= 0,
//
// the latter because int d(x) int_left^x s d = - int s d D = - int s (D^2/2)'. With E = int G_h p_h / P^2 therefore
//
//   b_0(d, d)/P^2 + (1/2) sum_k [s_k] (D(c_k)/P)^2 <= E.
//
// That bounds the load left of c_k, by [s_k] or, where it is small, by b_0 (load_bounds.hpp): with it each load share, the
// difference of two such loads, and the effective friction, their sum with the factors -[f_k].
//
// C_h is the least that makes G_h >= 0: with H of cell_gap.hpp, E = <H, p_h>/P - min H. The bound is sharp if H has one
// minimum for all cells under pressure; which p_h does, is the solver's affair.

#include <array>
#include <string>

#include "enclosure/cells/cell_pressures.hpp"
#include "enclosure/number/ball.hpp"
#include "enclosure/number/work_budget.hpp"

namespace steadyslide::enclosure {

struct CellBound {
  bool proved = false;
  std::string reason;  ///< why nothing is proved

  std::size_t cells = 0;
  Ball energy;       ///< E: exact, an upper bound, with room for whoever proves it again
  Ball sharpness;    ///< E cannot be less for these pressures
  Ball largest_gap;  ///< the largest mean of G_h on a cell under pressure, in units of c P
  /// In parts of P, left to right; [0, 1] where nothing better is known.
  std::vector<Ball> load_share;
  Ball effective_friction;
  // What proves it again: the state, and eps of load_bounds.hpp for each jump, to the left and to the right.
  std::vector<std::int64_t> weights;  ///< n_j
  std::vector<std::array<Rational, 2>> reaches;
};

/// `pressures`: -t on equal cells of the whole support, in the user's units. They are taken in proportion (their resultant
/// made P exactly); a resultant that is not P to a part in 10^6 is refused, as are pressures that are negative or no
/// numbers.
CellBound bound_cells(const ContactProblem& problem, std::span<const double> pressures, WorkBudget work);
/// With a budget that has room for many halvings of each cell.
CellBound bound_cells(const ContactProblem& problem, std::span<const double> pressures);

}  // namespace steadyslide::enclosure
