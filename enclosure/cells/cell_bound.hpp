#pragma once
// A proved error bound for pressures on equal cells, if s = +-gamma f nowhere decreases towards +x and the profile has
// no step.
//
// Pressures p = -t displace the surface downwards by -u = c B p, B p = -(1/pi) int p(x') log|x-x'| dx' + int_left^x s
// p, up to a constant. Let p >= 0 be a solution of finite energy (one exists: [Bal16, theorem 1]), its gap
// G = psi/c + B p - C >= 0, int p = P, int G p = 0. Let p_h >= 0 be any pressures with int p_h = P, and G_h = psi/c + B
// p_h - C_h >= 0 at every place of the support. Then d = p - p_h has no resultant, D(x) = int_left^x d vanishes at both
// ends, and
//
//   int d B d = int (p - p_h)(G - G_h) = int G_h p_h - int G p_h - int G_h p  <=  int G_h p_h,
//   int d B d = b_0(d, d) + (1/2) sum_k [s_k] D(c_k)^2,   b_0(d, d) = -(1/pi) int int d d log|x-x'| >= 0,
//
// the latter because int d(x) int_left^x s d = - int s d D = - int s (D^2/2)'. With E = int G_h p_h / P^2 therefore
//
//   b_0(d, d)/P^2 + (1/2) sum_k [s_k] (D(c_k)/P)^2 <= E.
//
// This bounds the load left of c_k, by [s_k] or, if that is small, by b_0 (load_bounds.hpp). So it also bounds each
// load share, which is the difference of two such loads, and the effective friction, which is their sum with the
// factors -[f_k].
//
// C_h is the limit value for which G_h >= 0: with H of cell_gap.hpp, E = <H, p_h>/P - min H. The bound is sharp if H
// has the same minimum in all cells under pressure. The solver must provide such a p_h.

#include <array>
#include <string>

#include "enclosure/cells/cell_pressures.hpp"
#include "enclosure/number/ball.hpp"
#include "enclosure/number/work_budget.hpp"

namespace steadyslide::enclosure {

struct CellBound {
  bool proved = false;
  std::string reason;  ///< the reason if nothing is proved

  std::size_t cells = 0;
  Ball energy;       ///< E: an exact number and an upper bound, with a margin for a second proof
  Ball sharpness;    ///< a lower bound of E for these pressures
  Ball largest_gap;  ///< the largest mean of G_h on a cell under pressure, in units of c P
  /// The load shares as fractions of P, from left to right; [0, 1] if nothing better is known.
  std::vector<Ball> load_share;
  Ball effective_friction;
  // The data for a second proof: the state, and eps of load_bounds.hpp for each jump, to the left and to the right.
  std::vector<std::int64_t> weights;  ///< n_j
  std::vector<std::array<Rational, 2>> reaches;
};

/// Returns the condition of the estimate that the problem does not meet: s nowhere decreases towards +x, for both
/// directions of sliding and both signs of gamma; no step; the attitude is given. Empty if it meets all.
std::string why_energy_bounds_nothing(const ContactProblem& problem);

/// Proves the bound. `pressures` are -t on equal cells of the whole support, in the user's units. They are scaled so
/// that their resultant is exactly P. A resultant that differs from P by more than 10^-6 is refused, and so are
/// pressures that are negative or not finite.
CellBound bound_cells(const ContactProblem& problem, std::span<const double> pressures, WorkBudget work);
/// The same with a budget for many halvings of each cell.
CellBound bound_cells(const ContactProblem& problem, std::span<const double> pressures);

}  // namespace steadyslide::enclosure
