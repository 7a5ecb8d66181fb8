#pragma once
// The conditions on a contact set (contact_newton.hpp), linear in the unknowns of one of Newton's steps: rho_f, the
// coefficients of r, and the change of the tilt.

#include <vector>

#include "numeric/riemann_hilbert/traction_representation.hpp"

namespace steadyslide::numeric {

template <Real R>
class ContactEquations {
 public:
  /// `form` has to outlive them.
  explicit ContactEquations(const TractionRepresentation<R>& form);

  /// False where the number of conditions is not that of the unknowns (ends that cannot move, though they are free).
  bool solve();
  /// Do the conditions beyond the number of unknowns hold? With an end that stays on a jump there is one more than
  /// there are ends that move: the end belongs there, or this is no solution.
  bool is_complete() const { return complete_; }

  /// Of the movable ends, in their order.
  std::vector<R> end_steps() const;
  R tilt_step() const { return tilts_ ? solution_.back() : R(0); }
  /// What rounding in the equations may have done to the unknowns.
  StateErrors<R> rounding() const;
  /// The change of q that goes with ends moved by `moved`, when `part` of the step is taken.
  std::vector<R> q_step(const std::vector<R>& moved, const R& part) const;

 private:
  bool has_pivots() const { return !form_.y().pivots().empty(); }
  /// sum_f rho_f/(x - e_f)
  R neighbours_at(const SurfacePoint<R>& place) const;
  std::vector<R> theta_step(const std::vector<R>& moved, const R& part) const;

  R& at(std::size_t column) { return equations_[row_][column]; }
  void set_right(const Estimate<R>& value);
  R end(std::size_t f) const { return form_.set().x(free_[f]); }
  void add_moments();
  void add_gaps();
  void add_centre();

  const TractionRepresentation<R>& form_;
  int degree_;
  std::vector<std::size_t> movable_;
  std::vector<std::size_t> free_;  ///< those that have a rho
  std::size_t coefficients_;       ///< of r
  bool tilts_;
  std::size_t size_;
  std::vector<std::vector<R>> equations_;  ///< with their right sides
  std::vector<R> errors_;                  ///< of the right sides
  std::vector<R> solution_;
  std::size_t row_ = 0;
  bool complete_ = true;
};

}  // namespace steadyslide::numeric
