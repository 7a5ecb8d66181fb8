#pragma once
// The stresses below the surface, caused by the traction t of a solution and t_t = -f t (f t sliding towards -x), at
// (x, z), z > 0 the depth: the field of half_plane_stress.hpp,
//
//   (sigma_xx, sigma_zz, sigma_xz) = (2/pi) int_K t(x') (s - r c)/d (c^2, s^2, c s) dx',
//   d^2 = (x-x')^2 + z^2,  c = (x-x')/d,  s = z/d,  r = t_t/t on each piece of the friction.
//
// As z -> 0 at a point of contact: sigma_zz -> t, sigma_xz -> -t_t = -r t, and with u_t'/c = H t_t + gamma t
// [Bal16, (2)] sigma_xx -> t + 2 H t_t = (1 - 2 gamma) t + 2 u_t'/c; where one ratio r rules the whole contact that is
// t + 2 r (u'/c + gamma r t). Off the contact sigma_zz and sigma_xz -> 0.
//
// Every segment of the contact is cut at x and graded towards it with z as the smallest scale, and towards the singular
// points of t; a panel with a power at its end has a Gauss-Jacobi rule, one that ends where the profile changes within
// the contact (logarithms, or a power and a constant) a double-exponential one. Distances to x are sums from x, not
// differences of coordinates: nothing is lost however small z is. The work grows like log(length/z).
//
// What the errors estimate: rounding, the traction's own error, and displaced free ends.

#include <map>

#include "numeric/interior/stress_state.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"

namespace steadyslide::numeric {

/// Not to be shared between threads.
template <Real R>
class InteriorStress {
 public:
  /// `solution` has to outlive the object.
  explicit InteriorStress(const RiemannHilbertSolution<R>& solution) : solution_(&solution) {}

  /// Throws std::invalid_argument unless z > 0.
  StressState<R> at(const Rational& x, const Rational& z) const;

 private:
  /// Part of a segment on one side of x. `x_left`: x minus the left end of the part.
  struct OneSidedPart {
    std::size_t segment;
    R from_left;
    R length;
    R from_right;
    R x_left;
    R x_right;
  };
  struct Sum {
    StressState<R> stress;
    R depth;
  };

  void add(const OneSidedPart& part, Sum& sum) const;
  void add_force(const Estimate<R>& force, const R& ratio, const R& x, Sum& sum) const;
  Surroundings<R> surroundings(const OneSidedPart& part, const R& depth) const;
  const JacobiRule<R>& double_exponential(const Power<R>& power) const;
  int nodes_per_panel() const;

  const RiemannHilbertSolution<R>* solution_;
  mutable JacobiRules<R> rules_;
  mutable std::map<R, JacobiRule<R>> double_exponential_rules_;  ///< by 1 + power
};

}  // namespace steadyslide::numeric
