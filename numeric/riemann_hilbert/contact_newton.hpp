#pragma once
// Newton's method for the contact set: its free ends e_f, the polynomial q and the tilt, such that
//
//   u'/(c Y) = m_0/z + m_1/z^2 + ... + q/pi has m_j = 0 for j < S and the load P/pi as the coefficient that belongs to
//   1/z of u'/c; the profile's height closes over every gap; the centre of pressure lies under load_at.
//
// The Jacobian needs no difference and no derivative of an integral: every neighbouring solution differs from the
// current one by Y (sum_f rho_f/(z - e_f) + r(z)), rho_f = p_f B(e_f) de_f, deg r < -S-1, and by a multiple of 1 - Y
// [1/Y]_poly for the tilt. (The growth at infinity leaves nothing else: Liouville's theorem.)
//
// With pivots (signed_fundamental_solution.hpp) there are no moments but m_0, which belongs to the load; B(e_i) = 0 at
// the pivots of components without an edge. The other free ends have their rho_f, components without a free end
// dtheta_i/pi in the place of rho. Where B(e_i) = 0 the solution is stationary in e_i (its energy is, like that of a
// crack whose stress intensity vanishes): a pivot does not enter the equations but follows from
//   B(e_i) - sum_f rho_f/(e_i - e_f) + dtilt + p_i B_i(e_i) de_i = 0,
// so that n components have n equations, and what is neglected is of second order.

#include <optional>

#include "numeric/riemann_hilbert/traction_representation.hpp"

namespace steadyslide::numeric {

/// What a solution of the local problem consists of.
template <Real R>
struct ContactState {
  ContactSet<R> set;
  std::vector<R> q;  ///< or theta (traction_representation.hpp)
  R tilt;

  /// For a set that is new: the load alone.
  static ContactState initial(const RoundedProblem<R>& problem, ContactSet<R> set, const R& tilt);
};

template <Real R>
struct NewtonResult {
  ContactState<R> state;
  enum class Status { converged, collapse, stalled } status;
  std::size_t collapsing = 0;  ///< the segment that wants to vanish
  std::optional<std::size_t> restless =
      std::nullopt;              ///< stalled: the end beyond a break that moved most, by its order
  R step = 0;                    ///< the last movement of an end, at the end of the iteration
  R change = 0;                  ///< and the last of a length that counts by its order of magnitude, relative
  StateErrors<R> rounding = {};  ///< what rounding in the equations may have done
};

/// `limit[k]`: a segment that shrinks below this length and wants to go on is reported as collapsing; of half a gap
/// over a notch the limit is RoundedProblem::shortest_gap().
template <Real R>
NewtonResult<R> solve_newton(const RoundedProblem<R>& problem, ContactState<R> state, const std::vector<R>& limits,
                             JacobiRules<R>& rules);

}  // namespace steadyslide::numeric
