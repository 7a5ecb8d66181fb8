#pragma once
// The conditions on a contact set (contact_newton.hpp). They are linear in the unknowns of one Newton step: rho_f, the
// coefficients of r, and the change of the tilt.

#include <vector>

#include "numeric/riemann_hilbert/traction_representation.hpp"

namespace steadyslide::numeric {

template <Real R>
class ContactEquations {
 public:
  /// `form` must outlive this object.
  explicit ContactEquations(const TractionRepresentation<R>& form);

  /// Returns false if the number of conditions differs from the number of unknowns (free ends that cannot move).
  bool solve();
  /// True if the conditions beyond the number of unknowns hold. With an end that stays on a jump there is one more
  /// condition than moving ends. If it does not hold, this is not a solution.
  bool is_complete() const { return complete_; }

  /// Returns the steps of the movable ends, in their order.
  std::vector<R> end_steps() const;
  R tilt_step() const { return tilts_ ? solution_.back() : R(0); }
  /// Returns the errors of the unknowns due to rounding in the equations.
  StateErrors<R> rounding() const;
  /// Returns the change of q if the ends move by `moved` and `part` of the step is taken.
  std::vector<R> q_step(const std::vector<R>& moved, const R& part) const;

 private:
  bool has_pivots() const { return !form_.y().pivots().empty(); }
  /// Returns sum_f rho_f/(x - e_f).
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
  std::vector<std::size_t> free_;  ///< the points that have a rho
  std::size_t coefficients_;       ///< of r
  bool tilts_;
  std::size_t size_;
  std::vector<std::vector<R>> equations_;  ///< with their right-hand sides
  std::vector<R> errors_;                  ///< of the right-hand sides
  std::vector<R> solution_;
  std::size_t row_ = 0;
  bool complete_ = true;
};

}  // namespace steadyslide::numeric
