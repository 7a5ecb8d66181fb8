#pragma once
// Newton's method for the contact set. The unknowns are its free ends e_f, the polynomial q and the tilt. The
// conditions are
//
//   u'/(c Y) = m_0/z + m_1/z^2 + ... + q/pi has m_j = 0 for j < S, and P/pi is the coefficient of 1/z in u'/c;
//   over every gap the height of the profile closes; the centre of pressure is at load_at.
//
// The Jacobian needs no difference and no derivative of an integral: every neighbouring solution differs from the
// current one by Y (sum_f rho_f/(z - e_f) + r(z)), rho_f = p_f B(e_f) de_f, deg r < -S-1, and by a multiple of 1 - Y
// [1/Y]_poly for the tilt. (By Liouville's theorem the growth at infinity allows nothing else.)
//
// With pivots (signed_fundamental_solution.hpp) the only moment is m_0, which gives the load, and B(e_i) = 0 at the
// pivots of components without an edge. The other free ends have a rho_f; components without a free end have
// dtheta_i/pi instead. If B(e_i) = 0, the solution is stationary in e_i (like the energy of a crack with zero stress
// intensity). So a pivot is not in the equations. It follows from
//   B(e_i) - sum_f rho_f/(e_i - e_f) + dtilt + p_i B_i(e_i) de_i = 0,
// so n components have n equations, and the neglected terms are of second order.

#include <optional>

#include "numeric/riemann_hilbert/traction_representation.hpp"

namespace steadyslide::numeric {

/// A solution of the local problem.
template <Real R>
struct ContactState {
  ContactSet<R> set;
  std::vector<R> q;  ///< q, or theta (traction_representation.hpp)
  R tilt;

  /// Returns the state of a new set: only the load is given.
  static ContactState initial(const RoundedProblem<R>& problem, ContactSet<R> set, const R& tilt);
};

template <Real R>
struct NewtonResult {
  ContactState<R> state;
  enum class Status { converged, collapse, stalled } status;
  std::size_t collapsing = 0;  ///< the segment that shrinks to zero
  std::optional<std::size_t> restless =
      std::nullopt;              ///< if stalled: the end beyond a break whose order of magnitude changed most
  R step = 0;                    ///< the last movement of an end, at the end of the iteration
  R change = 0;                  ///< the last relative change of a length that counts by its order of magnitude
  StateErrors<R> rounding = {};  ///< errors due to rounding in the equations
};

/// Solves for the contact set. A segment k that is shorter than `limits[k]` and still shrinks is reported as
/// collapsing. For half a gap over a notch, and for a gap beside a step, the limit is RoundedProblem::shortest_gap().
template <Real R>
NewtonResult<R> solve_newton(const RoundedProblem<R>& problem, ContactState<R> state, const std::vector<R>& limits,
                             JacobiRules<R>& rules);

}  // namespace steadyslide::numeric
